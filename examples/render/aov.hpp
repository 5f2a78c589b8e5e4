/// Arbitrary output variables: what the picture was made from, as named channels.
#pragma once

#include <common/gpu_device.hpp>
#include <common/image_file.hpp>
#include <pelagic/ocean.hpp>

namespace render {

enum class Aov { depth, position, normal, foam, variance, body };

/// The images that the composite stage writes for AOVs; null where none asked for them.
struct AovImages {
  common::OwnedImage normal;    ///< rgba32f: normal, foam.
  common::OwnedImage variance;  ///< rg32f.
};

/// Reads what `wanted` needs and adds its channels. `storage` keeps the pixels that the channels point to.
void addAovs(const common::GpuDevice& gpu, const std::vector<Aov>& wanted, const AovImages& images,
             const pelagic::WaterBuffer& water, const pelagic::Camera& camera, std::vector<std::vector<float>>& storage,
             std::vector<common::ExrChannel>& channels);

}  // namespace render
