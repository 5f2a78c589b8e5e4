#include <algorithm>
#include <cmath>
#include <numbers>
#include <physics/whitecaps.glsl>
#include <waves/whitecaps.hpp>

namespace pelagic {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

double totalDeviation(std::span<const JacobianSpread> bands) noexcept {
  double variance = 0;
  for (const JacobianSpread& band : bands) variance += band.deviation * band.deviation;
  return std::sqrt(variance);
}

/// Mean of max over s of (B(t - s) - s/lifetime) for one band, from the normal distribution of its Jacobian and Rice's
/// rate of crossings: E = E[B] + lifetime * integral of B * rate(B) dB.
double expectedFoam(const JacobianSpread& band, double inverseSpread, double threshold) noexcept {
  constexpr int kSteps = 512;
  constexpr double kRange = 8;  // standard deviations
  const double step = 2 * kRange / kSteps;
  const double crossings = band.rate / band.deviation / kTwoPi;
  double mean = 0;
  double fading = 0;
  double before = 0;
  for (int i = kSteps; i-- > 0;) {
    const double x = -kRange + (i + 0.5) * step;
    const double jacobian = 1 + band.deviation * x + band.curvature * band.deviation * band.deviation * (x * x - 1);
    const double coverage = shader::breakingCoverage(static_cast<float>(jacobian), static_cast<float>(threshold),
                                                     static_cast<float>(inverseSpread));
    const double bell = std::exp(-0.5 * x * x);
    mean += coverage * bell / std::sqrt(kTwoPi) * step;
    fading += 0.5 * (coverage * coverage - before * before) * crossings * bell;
    before = coverage;
  }
  // High crests come in groups, so that several crossings fade together where Rice counts each alone: over winds of 5
  // to 25 m/s the maps show about 0.85 of the sum. Independent events that overlap leave exp(-E) of the water bare.
  constexpr double kGrouping = 0.85;
  return -std::expm1(-kGrouping * (mean + kFoamLifetime * fading));
}

}  // namespace

JacobianSpread jacobianSpread(const CascadeModes& modes, const Cascade& cascade, std::uint32_t size,
                              double loopPeriod) {
  const double dk = kTwoPi / cascade.length;
  double variance = 0;
  double rate = 0;
  double alongX = 0;  // covariance of dDx/dx and s
  double mixed = 0;   // covariance of dDz/dx and s
  for (std::uint32_t row = 0; row < size; ++row) {
    for (std::uint32_t column = 0; column < size; ++column) {
      const std::size_t index = static_cast<std::size_t>(row) * size + column;
      if (modes.constants[index].cycles == 0) continue;
      const double kx = dk * modeOf(column, size);
      const double kz = dk * modeOf(row, size);
      const double chop = glm::length(glm::dvec2(modes.constants[index].chop));
      const double stretch = chop * (kx * kx + kz * kz);  // s = -chop k^2 h
      const double w = kTwoPi * modes.constants[index].cycles / loopPeriod;
      variance += stretch * stretch * modes.variance[index];
      rate += w * w * stretch * stretch * modes.variance[index];
      alongX += chop * kx * kx * stretch * modes.variance[index];
      mixed += chop * kx * kz * stretch * modes.variance[index];
    }
  }
  if (!(variance > 0)) return {};
  // Regress dDx/dx = a s + r, dDz/dz = (1 - a) s - r, dDz/dx = c s + q with r, q independent of s; of the determinant
  // a (1 - a) s^2 - c^2 s^2 moves with s, and E[dDx/dx dDz/dz] = E[dDz/dx^2].
  const double a = alongX / variance;
  const double c = mixed / variance;
  return {std::sqrt(variance), std::sqrt(rate), a * (1 - a) - c * c};
}

double inverseSpread(std::span<const JacobianSpread> bands, std::size_t cascade) noexcept {
  double variance = 0;
  for (std::size_t c = 0; c < bands.size(); ++c) {
    if (c != cascade) variance += bands[c].deviation * bands[c].deviation;
  }
  const double spread = std::max(std::sqrt(variance), 0.25 * bands[cascade].deviation);
  return spread > 0 ? 1 / spread : 1;
}

double expectedFoam(std::span<const JacobianSpread> bands, double threshold) noexcept {
  double sum = 0;
  for (std::size_t c = 0; c < bands.size(); ++c) {
    if (bands[c].deviation > 0) sum += expectedFoam(bands[c], inverseSpread(bands, c), threshold);
  }
  return sum;
}

double foamDecline(std::span<const JacobianSpread> bands, double threshold) noexcept {
  constexpr double kLull = 0.8;
  std::array<JacobianSpread, kMaxCascades> calmer{};
  for (std::size_t c = 0; c < bands.size(); ++c) {
    calmer[c] = {kLull * bands[c].deviation, kLull * bands[c].rate, bands[c].curvature};
  }
  const double foam = expectedFoam(bands, threshold);
  const double less = expectedFoam(std::span(calmer).first(bands.size()), threshold);
  // Where nothing breaks nothing declines, and a storm that is all foam does not gain any by calming.
  constexpr double kFastest = 100;
  if (!(less > 0)) return foam > 0 ? kFastest : 0;
  return std::clamp(std::log(foam / less) / (1 / (kLull * kLull) - 1), 0.0, kFastest);
}

double foldThreshold(std::span<const JacobianSpread> bands, double coverage) noexcept {
  constexpr double kNever = -1e6;
  const double deviation = totalDeviation(bands);
  if (!(deviation > 0)) return kNever;
  double low = 1 - 10 * deviation;
  double high = 1 + 2 * deviation;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (expectedFoam(bands, middle) < coverage ? low : high) = middle;
  }
  return low;
}

}  // namespace pelagic
