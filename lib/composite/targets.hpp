/// Checks of what a host gives to the composite stage.
#pragma once

#include <pelagic/composite.hpp>

namespace pelagic {

Result<void> validate(const CompositeTargets& targets, const WaterBuffer& water);
Result<void> validate(const SkyMaps& sky, const WaterBuffer& water);
Result<void> validate(const ToneMapInfo& info);

}  // namespace pelagic
