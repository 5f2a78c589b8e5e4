/// The filtered map of the sky's hemisphere that the water mirrors.
#pragma once

#include <sky/step.hpp>

namespace pelagic::sky {

class Environment {
 public:
  /// `radiance`: of sea level, looked up with `turning`. `dome`: clouds over it, or null.
  static Result<Environment> create(gpu::Context& context, const gpu::Image& radiance, vk::Sampler turning,
                                    vk::Sampler clamped, const gpu::Image* dome);
  /// The map and its mips; it rests in kShaderRead.
  void record(gpu::Context& context, vk::CommandBuffer commands) noexcept;

  gpu::Image image;

 private:
  Step step_;
  gpu::ComputePass mipPass_;
  std::vector<gpu::DescriptorSet> mipSets_;  ///< Element i writes mip i + 1.
};

}  // namespace pelagic::sky
