/// By how much the waves of the wind lean forward.
#pragma once

#include <pelagic/sea_state.hpp>

namespace pelagic {

/// Psi(k) [m^4] as waveNumberSpectrum(), by where the waves come from.
struct WindAndSwell {
  double wind = 0;
  double swell = 0;
};
WindAndSwell waveNumberSpectra(const SeaState& sea, double kx, double kz) noexcept;

/// Phase by which the horizontal displacement of a wave with the wind falls behind [rad], so that D = k A sin(lean)
/// forward at a crest.
double leanWithWind(const SeaState& sea) noexcept;

}  // namespace pelagic
