#include <cmath>
#include <numbers>
#include <waves/interpolation.hpp>

namespace pelagic {
namespace {

/// Along one axis, power of a wave's mean over the texels of a mip, and how much of it is left between them.
struct Response {
  double mean = 1;
  double between = 1;
};

/// Of a wave that turns by `angle` [rad] from sample to sample: the mean of 2^mip samples in a row, and the mean of
/// |1 - f + f e^{i t}|^2 over 0 <= f < 1, where t is its turn from texel to texel.
Response responseOf(double angle, std::uint32_t mip) noexcept {
  const double samples = std::exp2(mip);
  const double mean = angle != 0 ? std::sin(0.5 * samples * angle) / (samples * std::sin(0.5 * angle)) : 1;
  return {mean * mean, (2 + std::cos(samples * angle)) / 3};
}

/// Of every mip, the mean of weigh(x, z) over the modes' slopes, of their responses along both axes.
template <class Weigh>
std::array<double, 8> meanOverSlopes(const CascadeModes& modes, std::uint32_t size, Weigh weigh) {
  std::array<double, 8> means{};
  std::vector<Response> responses(size);
  for (std::uint32_t mip = 0; mip < means.size(); ++mip) {
    for (std::uint32_t i = 0; i < size; ++i) {
      responses[i] = responseOf(2 * std::numbers::pi * modeOf(i, size) / size, mip);
    }
    double slopes = 0;
    for (std::uint32_t row = 0; row < size; ++row) {
      for (std::uint32_t column = 0; column < size; ++column) {
        const double variance = modes.variance[std::size_t{row} * size + column];
        if (variance == 0) continue;
        const double slope = variance * (std::pow(modeOf(column, size), 2) + std::pow(modeOf(row, size), 2));
        slopes += slope;
        means[mip] += slope * weigh(responses[column], responses[row]);
      }
    }
    if (slopes > 0) means[mip] /= slopes;
  }
  return means;
}

}  // namespace

InterpolationLoss interpolationLoss(const CascadeModes& modes, std::uint32_t size) {
  return meanOverSlopes(
      modes, size, [](const Response& x, const Response& z) { return x.mean * z.mean * (1 - x.between * z.between); });
}

ResolvedShare resolvedShare(const CascadeModes& modes, std::uint32_t size) {
  return meanOverSlopes(modes, size,
                        [](const Response& x, const Response& z) { return x.mean * z.mean * x.between * z.between; });
}

}  // namespace pelagic
