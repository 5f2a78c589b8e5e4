/// What linear filtering takes from the slopes in the maps.
#pragma once

#include <waves/modes.hpp>

namespace pelagic {

/// As WaveMaps::interpolationLoss, of one cascade.
InterpolationLoss interpolationLoss(const CascadeModes& modes, std::uint32_t size);
/// As WaveMaps::resolvedShare, of one cascade.
ResolvedShare resolvedShare(const CascadeModes& modes, std::uint32_t size);

}  // namespace pelagic
