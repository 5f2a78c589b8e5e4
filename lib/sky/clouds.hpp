/// The clouds' volume and the shadow that they cast.
#pragma once

#include <shared/sky_pass.h>

#include <pelagic/sky.hpp>
#include <sky/mip_chain.hpp>

namespace pelagic::sky {

class Clouds {
 public:
  static Result<Clouds> create(gpu::Context& context, vk::Sampler repeat, vk::Sampler everywhere);
  /// `shape`: the layer changed; else only the sun that lights it.
  void record(gpu::Context& context, vk::CommandBuffer commands, const shader::CloudPass& push, bool shape) noexcept;
  /// No clouds, no shadow.
  void recordNone(gpu::Context& context, vk::CommandBuffer commands) noexcept;

  gpu::Image volume;  ///< rg16f: field, fourth root of the sun's transmittance.
  gpu::Image detail;  ///< r16f, repeats in all directions.
  gpu::Image shadow;  ///< rg16f with mips: SkyMaps::cloudShadow.

 private:
  void recordShape(gpu::Context& context, vk::CommandBuffer commands, const shader::CloudPass& push) noexcept;
  gpu::Image field_;
  Step shapeStep_, detailStep_, lightStep_, shadowStep_;
  MipChain shadowMips_;
  bool detailed_ = false;
};

/// `light`: toward sun or moon.
shader::CloudPass cloudPassOf(const SkyState& state, const glm::vec3& light) noexcept;

}  // namespace pelagic::sky
