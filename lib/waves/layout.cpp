#include <cmath>
#include <gpu/context.hpp>
#include <numbers>
#include <pelagic/waves.hpp>

namespace pelagic {

Result<WaveLayout> waveLayout(const SeaState& strongest, std::uint32_t count, std::uint32_t size, double span) {
  PELAGIC_CHECK(validate(strongest));
  if (count < 1 || count > kMaxCascades) {
    return gpu::reject("the number of cascades is " + std::to_string(count) + ", it must lie in 1 … " +
                       std::to_string(kMaxCascades));
  }
  if (size < 64 || size > 1024 || (size & (size - 1)) != 0) {
    return gpu::reject("the cascade size is " + std::to_string(size) + ", it must be a power of two in 64 … 1024");
  }
  if (!(span >= 0 && span <= 1e5)) {
    return gpu::reject("the span of the layout is " + std::to_string(span) + " m, it must lie in 0 … 100000 m");
  }
  // Outer edge at 0.7 of the Nyquist mode; the next patch is shorter by a ratio that puts the same wave number at its
  // mode >= 16. The factor e/2.8 makes every ratio of lengths irrational, so that the sum of all patches never repeats.
  const double outerMode = 0.7 * 0.5 * size;
  // No cascade is spent on waves shorter than a millimetre; their periods would not fit the longest loop either. Where
  // the cascades would reach beyond, they lie closer, but never closer than the least ratio.
  constexpr double kHighest = 8000;  // [rad/m]
  constexpr double kLeastRatio = 1.3;
  const double shortest = outerMode * 2 * std::numbers::pi / kHighest;
  double length = std::fmax(std::fmax(kPatchWavelengths * longestPeakWavelength(strongest), span),
                            shortest * std::pow(kLeastRatio, count - 1));
  double ratio = outerMode / 16 * (std::numbers::e / 2.8);
  if (count > 1) ratio = std::fmin(ratio, std::pow(length / shortest, 1.0 / (count - 1)));
  WaveLayout layout;
  layout.size = size;
  layout.count = count;
  double inner = 0;
  for (std::uint32_t c = 0; c < count; ++c) {
    const double outer = outerMode * 2 * std::numbers::pi / length;
    layout.cascades[c] = {length, inner, outer};
    inner = outer;
    length /= ratio;
  }
  return layout;
}

}  // namespace pelagic
