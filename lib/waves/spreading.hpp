/// Directional spreading functions D(w, theta), math. normalised: their integral over theta is 1 for every w.
#pragma once

#include <pelagic/sea_state.hpp>

namespace pelagic {

/// cos^2s(theta/2) with its norm Gamma(s+1) / (2 sqrt(pi) Gamma(s+1/2)) [1/rad]; s >= 0.
double cosinePower(double s, double theta) noexcept;

/// D of one frequency.
struct Directions {
  Spreading kind{};
  double shape = 0;    ///< s, beta or Delta of the kind.
  double sharpen = 0;  ///< Exponent s of a further cos^2s(theta/2).
  double norm = 1;
  /// [1/rad]; theta [rad] from the wind.
  double operator()(double theta) const noexcept;
};

/// What the spreading functions know of a frequency.
struct SpreadingPoint {
  double relative = 1;    ///< w / w_p [1].
  double inverseAge = 1;  ///< U10 w_p / g [1].
  double asymmetry = 0;   ///< Delta of unifiedAsymmetry() [1], for Spreading::elfouhaily.
  double sharpen = 0;     ///< As in Directions.
};
Directions directionsAt(Spreading kind, const SpreadingPoint& point) noexcept;

}  // namespace pelagic
