/// What the passes of the sky are made of.
#pragma once

#include <gpu/compute_pass.hpp>
#include <initializer_list>

namespace pelagic::sky {

/// A pipeline and its only set.
struct Step {
  gpu::ComputePass pass;
  gpu::DescriptorSet set;
};
/// `types`: of bindings 0, 1, 2 … `constants`: specialisation constants 0, 1, 2 …
Result<Step> createStep(gpu::Context& context, std::string_view name, std::span<const std::uint32_t> code,
                        std::initializer_list<vk::DescriptorType> types, std::uint32_t pushBytes,
                        std::span<const std::uint32_t> constants = {});

/// An image that shaders write and sample. `depth` more than 1: in three dimensions.
Result<gpu::Image> createMap(gpu::Context& context, std::string_view name, vk::Extent2D extent, std::uint32_t mips = 1,
                             vk::Format format = vk::Format::eR16G16B16A16Sfloat, std::uint32_t depth = 1);

}  // namespace pelagic::sky
