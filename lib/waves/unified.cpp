#include <algorithm>
#include <cmath>
#include <waves/unified.hpp>

namespace pelagic {
namespace {

/// Wave number and speed of the slowest wave (eq. 24) [rad/m], [m/s].
constexpr double kSlowestWaveNumber = 370;
constexpr double kSlowestSpeed = 0.23;
/// Dimensionless fetch k0 F that separates young from old seas (eq. 37).
constexpr double kFetchScale = 2.2e4;
/// Inverse wave age of the youngest sea that the spectrum describes.
constexpr double kYoungest = 5;
constexpr double kKarman = 0.41;

double phaseSpeed(double k) noexcept {
  const double ratio = k / kSlowestWaveNumber;
  return std::sqrt(kGravity / k * (1 + ratio * ratio));
}

/// Overshoot at the peak (eq. 3) and what is longer than it cut off (eq. 2).
double peakShape(const UnifiedSea& sea, double k) noexcept {
  const double age = sea.inverseAge;
  const double gamma = age <= 1 ? 1.7 : 1.7 + 6 * std::log10(age);
  const double sigma = 0.08 * (1 + 4 / (age * age * age));
  const double d = (std::sqrt(k / sea.peakWaveNumber) - 1) / sigma;
  const double ratio = sea.peakWaveNumber / k;
  return std::exp(-1.25 * ratio * ratio) * std::pow(gamma, std::exp(-0.5 * d * d));
}

}  // namespace

UnifiedSea unifiedSea(double windSpeed, double fetch) noexcept {
  UnifiedSea sea;
  const double k0 = kGravity / (windSpeed * windSpeed);
  sea.inverseAge = std::min(0.84 * std::pow(std::tanh(std::pow(k0 * fetch / kFetchScale, 0.4)), -0.75), kYoungest);
  sea.peakWaveNumber = k0 * sea.inverseAge * sea.inverseAge;
  // Eq. 66 and 61: the roughness grows with the wind and with the sea's youth.
  const double roughness = 3.7e-5 / k0 * std::pow(sea.inverseAge, 0.9);
  sea.friction = kKarman * windSpeed / std::log(10 / roughness);
  return sea;
}

double unifiedSpectrum(const UnifiedSea& sea, double k) noexcept {
  const double c = phaseSpeed(k);
  const double peakSpeed = phaseSpeed(sea.peakWaveNumber);
  // Curvatures of long waves (eq. 31, 32, 34) and of short ones (eq. 40, 41, 44); calm air raises no short ones.
  const double age = sea.inverseAge;
  const double damped = std::exp(-age / std::sqrt(10) * (std::sqrt(k / sea.peakWaveNumber) - 1));
  const double longWaves = 0.5 * 6e-3 * std::pow(age, 0.55) * peakSpeed / c * damped;
  const double push = std::log(sea.friction / kSlowestSpeed);
  const double alpha = std::max(0.01 * (1 + (push < 0 ? push : 3 * push)), 0.0);
  const double d = k / kSlowestWaveNumber - 1;
  const double shortWaves = 0.5 * alpha * kSlowestSpeed / c * std::exp(-0.25 * d * d);
  return (longWaves + shortWaves) * peakShape(sea, k) / (k * k * k);
}

double unifiedAsymmetry(const UnifiedSea& sea, double k) noexcept {
  // Eq. 57 and 59.
  const double c = phaseSpeed(k);
  const double peakSpeed = phaseSpeed(sea.peakWaveNumber);
  return std::tanh(0.25 * std::log(2.0) + 4 * std::pow(c / peakSpeed, 2.5) +
                   0.13 * sea.friction / kSlowestSpeed * std::pow(kSlowestSpeed / c, 2.5));
}

}  // namespace pelagic
