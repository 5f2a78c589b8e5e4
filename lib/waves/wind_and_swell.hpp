/// The spectrum over wave numbers, parted into wind sea and swell.
#pragma once

#include <pelagic/sea_state.hpp>

namespace pelagic {

/// Psi(k) [m^4] as waveNumberSpectrum(), by where the waves come from.
struct WindAndSwell {
  double wind = 0;
  double swell = 0;
};
WindAndSwell waveNumberSpectra(const SeaState& sea, double kx, double kz) noexcept;

}  // namespace pelagic
