/// The filtered map of the sky's hemisphere that the water mirrors.
#pragma once

#include <sky/mip_chain.hpp>

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
  MipChain mips_;
};

}  // namespace pelagic::sky
