/// Directional spreading functions D(w, theta), math. normalised: their integral over theta is 1 for every w.
#pragma once

#include <pelagic/sea_state.hpp>

namespace pelagic {

/// cos^2s(theta/2) with its norm Gamma(s+1) / (2 sqrt(pi) Gamma(s+1/2)) [1/rad]; s >= 0.
double cosinePower(double s, double theta) noexcept;
/// `relative`: w / w_p; `inverseAge`: U10 w_p / g; theta [rad] from the wind.
double spreading(Spreading kind, double relative, double inverseAge, double theta) noexcept;

}  // namespace pelagic
