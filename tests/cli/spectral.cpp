#include "spectral.hpp"

#include <cmath>
#include <numbers>

namespace cli {
namespace {

using Complex = std::complex<double>;
constexpr double kTwoPi = 2 * std::numbers::pi;

std::size_t at(int row, int column, int size) { return static_cast<std::size_t>(row * size + column); }

/// exp(i sign 2 pi p / N) for p = 0 ... N-1.
std::vector<Complex> roots(int size, double sign) {
  std::vector<Complex> list(static_cast<std::size_t>(size));
  for (int p = 0; p < size; ++p) list[static_cast<std::size_t>(p)] = std::polar(1.0, sign * kTwoPi * p / size);
  return list;
}

/// DFT of every row.
std::vector<Complex> rows(const std::vector<Complex>& field, int size, double sign) {
  const std::vector<Complex> root = roots(size, sign);
  std::vector<Complex> result(field.size());
  for (int i = 0; i < size; ++i) {
    for (int m = 0; m < size; ++m) {
      Complex sum = 0;
      for (int j = 0; j < size; ++j) sum += field[at(i, j, size)] * root[static_cast<std::size_t>(m * j % size)];
      result[at(i, m, size)] = sum;
    }
  }
  return result;
}

std::vector<Complex> transposed(const std::vector<Complex>& field, int size) {
  std::vector<Complex> result(field.size());
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) result[at(j, i, size)] = field[at(i, j, size)];
  }
  return result;
}

}  // namespace

std::vector<Complex> transform(const std::vector<double>& field, int size) {
  std::vector<Complex> result(field.begin(), field.end());
  result = transposed(rows(transposed(rows(result, size, -1), size), size, -1), size);
  for (Complex& value : result) value /= static_cast<double>(size) * size;
  return result;
}

std::vector<double> derivative(const std::vector<double>& field, int size, double length, Axis axis) {
  std::vector<Complex> work(field.begin(), field.end());
  if (axis == Axis::z) work = transposed(work, size);
  work = rows(work, size, -1);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      const int mode = j == size / 2 ? 0 : modeOf(j, size);
      work[at(i, j, size)] *= Complex(0, kTwoPi * mode / length / size);
    }
  }
  work = rows(work, size, 1);
  if (axis == Axis::z) work = transposed(work, size);
  std::vector<double> result(work.size());
  for (std::size_t i = 0; i < work.size(); ++i) result[i] = work[i].real();
  return result;
}

double relativeError(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0;
  double norm = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    difference += (a.at(i) - b[i]) * (a.at(i) - b[i]);
    norm += b[i] * b[i];
  }
  return std::sqrt(difference / norm);
}

}  // namespace cli
