/// Images that cross the boundary, with their synchronisation states.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>

namespace pelagic {

/// Who touched an image last, or will touch it next.
struct ImageState {
  VkPipelineStageFlags2 stages = VK_PIPELINE_STAGE_2_NONE;
  VkAccessFlags2 access = VK_ACCESS_2_NONE;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

/// Where every map of Pelagic rests between record calls: readable by any shader.
inline constexpr ImageState kShaderRead{VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT |
                                            VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT |
                                            VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                                        VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};

/// An image of the host, given to Pelagic for one recording.
struct HostImage {
  VkImage image = VK_NULL_HANDLE;
  /// 2-D view of mip 0, layer 0.
  VkImageView view = VK_NULL_HANDLE;
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkExtent2D extent{};
  ImageState before;  ///< As the host leaves it when record() begins.
  ImageState after;   ///< As the host wants it when record() has ended; `after.layout` must not be UNDEFINED.
};

/// An image that Pelagic owns and a host may sample. It rests in kShaderRead between record calls.
struct MapView {
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;  ///< All mips and layers.
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkExtent2D extent{};
  std::uint32_t layers = 1;
  std::uint32_t mips = 1;
};

}  // namespace pelagic
