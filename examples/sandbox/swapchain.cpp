#include "swapchain.hpp"

#include <algorithm>
#include <limits>

namespace sandbox {
namespace {

/// 8 bits without sRGB conversion: the tone map has encoded already.
vk::SurfaceFormatKHR chooseFormat(const std::vector<vk::SurfaceFormatKHR>& formats) {
  const auto plain = std::find_if(formats.begin(), formats.end(), [](const vk::SurfaceFormatKHR& format) {
    return format.format == vk::Format::eB8G8R8A8Unorm || format.format == vk::Format::eR8G8B8A8Unorm;
  });
  if (plain == formats.end()) throw std::runtime_error("the window has no 8-bit format");
  return *plain;
}

}  // namespace

Swapchain::Swapchain(const common::GpuDevice& gpu, vk::SurfaceKHR surface, vk::Extent2D wanted)
    : device_(gpu.device()) {
  if (!gpu.physicalDevice().getSurfaceSupportKHR(gpu.queueFamily(), surface)) {
    throw std::runtime_error(gpu.name() + " cannot present to this window");
  }
  const auto limits = gpu.physicalDevice().getSurfaceCapabilitiesKHR(surface);
  const auto format = chooseFormat(gpu.physicalDevice().getSurfaceFormatsKHR(surface));
  const bool fixed = limits.currentExtent.width != std::numeric_limits<std::uint32_t>::max();
  extent_ = fixed ? limits.currentExtent : wanted;
  vk::SwapchainCreateInfoKHR info;
  info.surface = surface;
  info.minImageCount = std::max(3u, limits.minImageCount);
  if (limits.maxImageCount > 0) info.minImageCount = std::min(info.minImageCount, limits.maxImageCount);
  info.imageFormat = format.format;
  info.imageColorSpace = format.colorSpace;
  info.imageExtent = extent_;
  info.imageArrayLayers = 1;
  info.imageUsage = vk::ImageUsageFlagBits::eTransferDst;
  info.preTransform = limits.currentTransform;
  info.compositeAlpha = vk::CompositeAlphaFlagBitsKHR::eOpaque;
  info.presentMode = vk::PresentModeKHR::eFifo;
  info.clipped = VK_TRUE;
  swapchain_ = device_.createSwapchainKHRUnique(info);
  images_ = device_.getSwapchainImagesKHR(*swapchain_);
  for (std::size_t i = 0; i < images_.size(); ++i) drawn_.push_back(device_.createSemaphoreUnique({}));
}

std::optional<std::uint32_t> Swapchain::acquire(vk::Semaphore acquired) const {
  constexpr std::uint64_t kTimeout = 60'000'000'000;  // one minute in ns
  std::uint32_t index = 0;
  const vk::Result result = device_.acquireNextImageKHR(*swapchain_, kTimeout, acquired, {}, &index);
  if (result == vk::Result::eErrorOutOfDateKHR) return std::nullopt;
  if (result != vk::Result::eSuccess && result != vk::Result::eSuboptimalKHR) {
    throw std::runtime_error("the window gives no image: " + vk::to_string(result));
  }
  return index;
}

void Swapchain::recordCopy(vk::CommandBuffer commands, vk::Image picture, std::uint32_t index) const {
  using Stage = vk::PipelineStageFlagBits2;
  using Access = vk::AccessFlagBits2;
  const vk::ImageSubresourceRange whole(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
  vk::ImageMemoryBarrier2 barrier(Stage::eAllTransfer, Access::eNone, Stage::eAllTransfer, Access::eTransferWrite,
                                  vk::ImageLayout::eUndefined, vk::ImageLayout::eTransferDstOptimal,
                                  VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, images_[index], whole);
  commands.pipelineBarrier2({{}, {}, {}, barrier});
  const vk::ImageSubresourceLayers layer(vk::ImageAspectFlagBits::eColor, 0, 0, 1);
  const std::array<vk::Offset3D, 2> corners{
      vk::Offset3D(0, 0, 0),
      vk::Offset3D(static_cast<std::int32_t>(extent_.width), static_cast<std::int32_t>(extent_.height), 1)};
  // A blit, because the window's format may have another order of channels.
  commands.blitImage(picture, vk::ImageLayout::eTransferSrcOptimal, images_[index],
                     vk::ImageLayout::eTransferDstOptimal, vk::ImageBlit(layer, corners, layer, corners),
                     vk::Filter::eNearest);
  barrier.srcAccessMask = Access::eTransferWrite;
  barrier.dstStageMask = Stage::eNone;  // the semaphore orders the presentation
  barrier.dstAccessMask = Access::eNone;
  barrier.oldLayout = vk::ImageLayout::eTransferDstOptimal;
  barrier.newLayout = vk::ImageLayout::ePresentSrcKHR;
  commands.pipelineBarrier2({{}, {}, {}, barrier});
}

bool Swapchain::present(vk::Queue queue, std::uint32_t index) const {
  const vk::PresentInfoKHR info(*drawn_[index], *swapchain_, index);
  const vk::Result result = queue.presentKHR(&info);
  if (result == vk::Result::eErrorOutOfDateKHR || result == vk::Result::eSuboptimalKHR) return false;
  if (result != vk::Result::eSuccess) throw std::runtime_error("cannot present: " + vk::to_string(result));
  return true;
}

}  // namespace sandbox
