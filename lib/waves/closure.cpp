#include <algorithm>
#include <cmath>
#include <waves/closure.hpp>

namespace pelagic {

double shortestWaveNumber(const SeaState& sea) noexcept {
  constexpr double kLast = 1e4;
  constexpr double kStep = 0.01;  // in ln k, fine enough for JONSWAP's peak
  const SlopeVariance measured = coxMunkSlopes(sea.windSpeed);
  double left = measured.upwind + measured.crosswind;
  const double peak = waveNumberOf(peakFrequency(sea), sea.depth);
  double from = std::log(1e-2 * peak);
  for (; from < std::log(kLast); from += kStep) {
    const double k = std::exp(from + 0.5 * kStep);
    const double slope =
        kStep * k * k * k * groupSpeed(k, sea.depth) * windSeaSpectrum(sea, angularFrequency(k, sea.depth));
    if (slope > left) return std::clamp(std::exp(from + kStep * left / slope), std::min(10 * peak, kLast), kLast);
    left -= slope;
  }
  return kLast;
}

}  // namespace pelagic
