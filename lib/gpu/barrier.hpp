/// Barriers that know the state a resource was left in.
#pragma once

#include <array>
#include <gpu/resources.hpp>

namespace pelagic::gpu {

inline constexpr ImageState kComputeStorageWrite{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                                                 VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL};
inline constexpr ImageState kComputeSampled{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                                            VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
inline constexpr ImageState kTransferDestination{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
inline constexpr BufferState kComputeRead{vk::PipelineStageFlagBits2::eComputeShader,
                                          vk::AccessFlagBits2::eShaderStorageRead | vk::AccessFlagBits2::eUniformRead};
inline constexpr BufferState kComputeWrite{vk::PipelineStageFlagBits2::eComputeShader,
                                           vk::AccessFlagBits2::eShaderStorageWrite};
inline constexpr BufferState kComputeTexelRead{vk::PipelineStageFlagBits2::eComputeShader,
                                               vk::AccessFlagBits2::eShaderSampledRead};
inline constexpr BufferState kHostRead{vk::PipelineStageFlagBits2::eHost, vk::AccessFlagBits2::eHostRead};
inline constexpr BufferState kTransferWrite{vk::PipelineStageFlagBits2::eAllTransfer,
                                            vk::AccessFlagBits2::eTransferWrite};
inline constexpr BufferState kIndirectRead{vk::PipelineStageFlagBits2::eDrawIndirect,
                                           vk::AccessFlagBits2::eIndirectCommandRead};

/// Collects transitions and records them as one vkCmdPipelineBarrier2.
class Barrier {
 public:
  /// Makes `image` ready for `next`. `discard`: its contents are not needed.
  Barrier& image(Image& image, const ImageState& next, bool discard = false) noexcept;
  Barrier& buffer(Buffer& buffer, const BufferState& next) noexcept;
  /// An image whose states the caller tracks; all mips and layers.
  Barrier& image(vk::Image image, vk::ImageAspectFlags aspect, const ImageState& before,
                 const ImageState& after) noexcept;
  /// One mip of an image in a chain of passes, not tracked.
  Barrier& mip(const Image& image, std::uint32_t mip, const ImageState& before, const ImageState& after) noexcept;
  void record(const Context& context, vk::CommandBuffer commands) noexcept;

 private:
  static constexpr std::size_t kCapacity = 32;
  std::array<vk::ImageMemoryBarrier2, kCapacity> images_;
  std::array<vk::BufferMemoryBarrier2, kCapacity> buffers_;
  std::uint32_t imageCount_ = 0;
  std::uint32_t bufferCount_ = 0;
};

}  // namespace pelagic::gpu
