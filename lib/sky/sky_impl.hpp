/// What the sky of sea level and the views of it share.
#pragma once

#include <shared/sky_pass.h>

#include <gpu/barrier.hpp>
#include <gpu/compute_pass.hpp>
#include <pelagic/sky.hpp>
#include <vector>

namespace pelagic {

namespace sky {

/// A pipeline and its only set.
struct Step {
  gpu::ComputePass pass;
  gpu::DescriptorSet set;
};
/// `types`: of bindings 0, 1, 2 …
Result<Step> createStep(gpu::Context& context, std::string_view name, std::span<const std::uint32_t> code,
                        std::initializer_list<vk::DescriptorType> types);
/// rgba16f, written and sampled by shaders.
Result<gpu::Image> createMap(gpu::Context& context, std::string_view name, std::uint32_t width, std::uint32_t height,
                             std::uint32_t mips = 1);

/// `airRows`: 0, or shader::kAirRows for the maps of an eye at `altitude` [m].
shader::SkyPass passOf(const SkyState& state, double altitude, std::uint32_t airRows) noexcept;

}  // namespace sky

struct Sky::Impl {
  gpu::Context* context = nullptr;
  SkyState state;
  bool airChanged = true;  ///< What depends on the haze alone must be computed again.
  bool changed = true;
  std::uint64_t version = 0;  ///< Counts the states that were recorded.
  gpu::Image transmittance, clear, radiance, environment;
  gpu::Buffer scattering, light;
  gpu::Unique<vk::Sampler> clamped, turning;
  sky::Step transmittanceStep, scatteringStep, clearStep, lightStep, radianceStep, environmentStep;
  gpu::ComputePass mipPass;
  std::vector<gpu::DescriptorSet> mipSets;  ///< Element i writes mip i + 1.

  Result<void> createResources();
  Result<void> createSteps();
  void recordAir(vk::CommandBuffer commands, const shader::SkyPass& push, Timings* timings) noexcept;
  void recordRadiance(vk::CommandBuffer commands, const shader::SkyPass& push, Timings* timings) noexcept;
  void recordEnvironment(vk::CommandBuffer commands, Timings* timings) noexcept;
};

}  // namespace pelagic
