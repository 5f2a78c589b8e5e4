/// Exact derivatives and spectra of periodic N x N fields, by plain sums: no FFT that could share a mistake.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace cli {

/// Index of a mode m = -N/2 ... N/2-1 in FFT order, and back.
inline int modeOf(int index, int size) { return index < size / 2 ? index : index - size; }

/// Two-dimensional DFT of a real field, row = z: sum of f(i,j) exp(-2 pi i (m j + n i)/N) / N^2, in FFT order.
std::vector<std::complex<double>> transform(const std::vector<double>& field, int size);

enum class Axis { x, z };
/// Derivative of a band-limited periodic field along columns (x) or rows (z) of a patch of side `length`.
std::vector<double> derivative(const std::vector<double>& field, int size, double length, Axis axis);

/// Root mean square of a - b over that of b.
double relativeError(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace cli
