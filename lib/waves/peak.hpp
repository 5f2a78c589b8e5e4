/// Where the energy of the grid's modes peaks.
#pragma once

#include <waves/modes.hpp>

namespace pelagic {

/// Peak frequency as integral w S^4 dw / integral S^4 dw [rad/s] (Young 1995), by quadrature. 0 without energy. It lies
/// above the maximum of S by an amount that the shape of S decides: 1 % for JONSWAP, 5 % for Pierson & Moskowitz.
double weightedPeakFrequency(const SeaState& sea);

/// The energy of modes by frequency. Their frequencies are a comb, whose own largest entry says little.
class ModeEnergies {
 public:
  ModeEnergies();
  void add(const CascadeModes& modes, double loopPeriod) noexcept;
  /// Young's peak frequency with one of the four S replaced by the modes, sum w S^3 E / sum S^3 E [rad/s], which no
  /// comb disturbs: a sum over modes of something smooth. 0 without energy.
  double weightedPeakFrequency(const SeaState& sea) const;

 private:
  struct Bin {
    double energy = 0;  ///< [m^2]
    double moment = 0;  ///< Sum of energy times frequency [m^2 rad/s].
  };
  std::vector<Bin> bins_;
};

/// The target's peak period moved by as much as the modes' weighted peak is off the target's [s], so that the
/// estimator's own distance from the maximum drops out. 0 without energy.
double gridPeakPeriod(const SeaState& sea, const ModeEnergies& modes);

}  // namespace pelagic
