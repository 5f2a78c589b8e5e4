/// Box-filtered mips of the wave maps, with the slope covariance that filtering takes out of the gradients.
#pragma once

#include <waves/transform.hpp>

namespace pelagic {

class WaveFilter {
 public:
  static Result<WaveFilter> create(gpu::Context& context, const WavesInfo& info, const WaveImages& images);

  /// Makes all mips from the finest, which must have been written to displacement[target] and the other maps in GENERAL
  /// layout; leaves them so, written by compute.
  void record(vk::CommandBuffer commands, WaveImages& images, std::uint32_t target) noexcept;

 private:
  gpu::Context* context_ = nullptr;
  std::uint32_t size_ = 0;
  std::uint32_t count_ = 0;
  std::uint32_t foamCascades_ = 0;
  std::uint32_t mips_ = 0;
  gpu::ComputePass pass_;
  /// [displacement target][from mip 0, from mip kFilterLevels]
  std::array<std::array<gpu::DescriptorSet, 2>, 2> sets_;
};

}  // namespace pelagic
