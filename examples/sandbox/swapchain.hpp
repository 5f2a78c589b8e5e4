/// The images of the window and their turn.
#pragma once

#include <common/gpu_device.hpp>
#include <optional>

namespace sandbox {

class Swapchain {
 public:
  /// Throws when the device cannot present to the surface.
  Swapchain(const common::GpuDevice& gpu, vk::SurfaceKHR surface, vk::Extent2D wanted);

  vk::Extent2D extent() const { return extent_; }
  /// Index of the next image, free when `acquired` is signalled; none when the window changed its size.
  std::optional<std::uint32_t> acquire(vk::Semaphore acquired) const;
  /// Copies `picture`, in TRANSFER_SRC layout and of the same extent, into image `index`, ready to be presented.
  void recordCopy(vk::CommandBuffer commands, vk::Image picture, std::uint32_t index) const;
  /// Signalled by the submission that draws image `index`.
  vk::Semaphore drawn(std::uint32_t index) const { return *drawn_[index]; }
  /// False when the window changed its size.
  bool present(vk::Queue queue, std::uint32_t index) const;

 private:
  vk::Device device_;
  vk::Extent2D extent_;
  vk::UniqueSwapchainKHR swapchain_;
  std::vector<vk::Image> images_;
  std::vector<vk::UniqueSemaphore> drawn_;
};

}  // namespace sandbox
