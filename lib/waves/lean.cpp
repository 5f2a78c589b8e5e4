#include <cmath>
#include <pelagic/spectrum.hpp>
#include <waves/lean.hpp>

namespace pelagic {

double leanWithWind(const SeaState& sea) noexcept {
  // The slope over the displaced surface is h' / (1 + D'), and of that surface a stretch has the part 1 + D'. To the
  // first order in D' the mean of its cube is -6 E[h'^2] E[h' D'], where E[h' D'] is the slope variance times sin(lean)
  // for waves along the wind. Those that go askew lean less and their lean counts less: 0.8 of it, the mean of cos^4
  // over that of cos^2 for spreadings between even and cos^2 within 90 degrees of the wind (3/4 and 5/6).
  constexpr double kAlong = 0.8;
  // The quotient is 0.42 at most, at 14 m/s.
  const double deviation = std::sqrt(coxMunkSlopes(sea.windSpeed).upwind);
  return sea.asymmetry * std::asin(-coxMunkSkewness(sea.windSpeed) / (6 * kAlong * deviation));
}

}  // namespace pelagic
