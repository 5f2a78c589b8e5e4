/// Where the sea's slopes end.
#pragma once

#include <pelagic/spectrum.hpp>

namespace pelagic {

/// The largest wave number of waves on the grid, and of slopes at all [rad/m], at most 1e4: 0.6 mm. The laws of wind
/// seas are laws of the waves that carry the energy; in light wind, drawn out to ripples, they are steeper than the
/// sea. It is where the wind sea, without SeaState::octaveGain, has all the mean square slope that Cox & Munk measured,
/// but not within ten times the peak's wave number, which would be missed in the height.
double shortestWaveNumber(const SeaState& sea) noexcept;

}  // namespace pelagic
