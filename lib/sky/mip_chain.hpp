/// The mips of a square map, filtered from the finest on.
#pragma once

#include <sky/step.hpp>
#include <vector>

namespace pelagic::sky {

class MipChain {
 public:
  /// `sampler` says what lies beyond the map's edge.
  static Result<MipChain> create(gpu::Context& context, std::string_view name, const gpu::Image& map,
                                 vk::Sampler sampler);
  /// After a pass that wrote the finest mip of `map`, which then rests in kShaderRead.
  void record(const gpu::Context& context, vk::CommandBuffer commands, gpu::Image& map) const noexcept;

 private:
  gpu::ComputePass pass_;
  std::vector<gpu::DescriptorSet> sets_;  ///< Element i writes mip i + 1.
};

}  // namespace pelagic::sky
