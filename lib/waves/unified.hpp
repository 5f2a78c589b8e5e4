/// The unified directional spectrum of Elfouhaily, Chapron, Katsaros & Vandemark (1997), JGR 102(C7): one formula from
/// the longest wind wave to capillaries. Equation numbers are theirs.
#pragma once

#include <pelagic/sea_state.hpp>

namespace pelagic {

/// Wind and fetch as the spectrum sees them.
struct UnifiedSea {
  double inverseAge = 0;      ///< Omega_c = U10 / c_p [1], 0.84 … 5.
  double peakWaveNumber = 0;  ///< k_p [rad/m].
  double friction = 0;        ///< u*, friction velocity [m/s].
};
UnifiedSea unifiedSea(double windSpeed, double fetch) noexcept;

/// S(k) [m^3] of deep water, over all directions: its integral over k is m0.
double unifiedSpectrum(const UnifiedSea& sea, double waveNumber) noexcept;
/// Delta(k) [1]: how much more waves of a wave number go with the wind than across it, 0 … 1.
double unifiedAsymmetry(const UnifiedSea& sea, double waveNumber) noexcept;

}  // namespace pelagic
