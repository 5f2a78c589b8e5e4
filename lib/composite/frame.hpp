/// The composite passes' frame block from what the API gives.
#pragma once

#include <pelagic/camera.hpp>
#include <pelagic/composite.hpp>

#include "shared/composite.h"

namespace pelagic {

shader::CompositeFrame compositeFrame(const WaveMaps& waves, const WaterBuffer& water, const Camera& camera,
                                      const WaterMedium& medium, VkExtent2D extent,
                                      std::span<const HostLight> lights) noexcept;

}  // namespace pelagic
