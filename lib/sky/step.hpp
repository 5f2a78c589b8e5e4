/// What the passes of the sky are made of.
#pragma once

#include <array>
#include <gpu/barrier.hpp>
#include <gpu/compute_pass.hpp>
#include <initializer_list>

namespace pelagic::sky {

/// A pipeline and its only set.
struct Step {
  gpu::ComputePass pass;
  gpu::DescriptorSet set;

  /// Dispatches so many work-groups.
  template <class Push>
  void run(vk::CommandBuffer commands, const Push& push, std::uint32_t x, std::uint32_t y = 1,
           std::uint32_t z = 1) const noexcept {
    pass.bind(commands, set);
    pass.push(commands, push);
    pass.dispatch(commands, x, y, z);
  }
};
/// Specialisation constants of passes with physics/atmosphere.glsl: its kPlanetRadius is 1.
std::array<std::uint32_t, 2> aroundPlanet(double radius) noexcept;
/// `types`: of bindings 0, 1, 2 … `constants`: specialisation constants 0, 1, 2 …
Result<Step> createStep(gpu::Context& context, std::string_view name, std::span<const std::uint32_t> code,
                        std::initializer_list<vk::DescriptorType> types, std::uint32_t pushBytes,
                        std::span<const std::uint32_t> constants = {});

/// An image that shaders write and sample. `depth` more than 1: in three dimensions.
Result<gpu::Image> createMap(gpu::Context& context, std::string_view name, vk::Extent2D extent, std::uint32_t mips = 1,
                             vk::Format format = vk::Format::eR16G16B16A16Sfloat, std::uint32_t depth = 1);
/// Fills a map, which then rests in kShaderRead.
void clearMap(const gpu::Context& context, vk::CommandBuffer commands, gpu::Image& map,
              const std::array<float, 4>& value) noexcept;

}  // namespace pelagic::sky
