/// Dear ImGui on top of the picture.
#pragma once

#include <common/gpu_device.hpp>

#include "window.hpp"

namespace sandbox {

class Picture;

/// One at a time, as Dear ImGui's context is global.
class Overlay {
 public:
  Overlay(const common::GpuDevice& gpu, const Window& window, std::uint32_t framesInFlight);
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;
  ~Overlay();

  /// The picture to draw upon, until the next call.
  void bind(const Picture& picture);
  /// Starts the frame's controls; draw them with ImGui until record().
  void begin();
  /// Draws them onto the picture, which comes in kOverlayTarget and is left ready to be copied from.
  void record(vk::CommandBuffer commands);

 private:
  const common::GpuDevice* gpu_;
  vk::UniqueDescriptorPool pool_;
  vk::UniqueRenderPass pass_;
  vk::UniqueFramebuffer framebuffer_;
  vk::Extent2D extent_;
};

}  // namespace sandbox
