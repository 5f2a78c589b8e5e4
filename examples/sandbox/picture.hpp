/// The ocean as the sandbox draws it: radiance, then the picture that the controls lie upon.
#pragma once

#include <common/scene.hpp>

#include "common/gpu_device.hpp"

namespace sandbox {

/// The picture after Picture::record, as the overlay wants it.
inline constexpr pelagic::ImageState kOverlayTarget{
    VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
    VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
    VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};

/// The images of one window size.
class Picture {
 public:
  static constexpr vk::Format kFormat = vk::Format::eR8G8B8A8Unorm;

  Picture(const common::GpuDevice& gpu, pelagic::Device& device, vk::Extent2D extent);

  vk::Extent2D extent() const { return screen_.extent; }
  vk::Image image() const { return *screen_.image; }
  vk::ImageView view() const { return *screen_.view; }
  /// Another ocean draws into the same images from now on.
  void bind(pelagic::Ocean& ocean);
  void release() { view_.reset(); }
  void record(VkCommandBuffer commands, const pelagic::Camera& camera, const common::Scene& scene,
              pelagic::Timings& timings);

 private:
  common::OwnedImage hdr_;
  common::OwnedImage screen_;
  pelagic::ToneMap toneMap_;
  std::optional<pelagic::OceanView> view_;
};

}  // namespace sandbox
