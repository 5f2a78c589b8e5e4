/// A host's picture of the sky on the device.
#pragma once

#include <shared/sky_pass.h>

#include <sky/host_sky.hpp>
#include <sky/step.hpp>

namespace pelagic::sky {

/// Its size is fixed. Empty without a picture.
class HostPicture {
 public:
  static Result<HostPicture> create(gpu::Context& context, const HostSky& sky);
  /// A pass that shows it in the layout of the radiance map.
  Result<Step> createStep(gpu::Context& context, vk::Sampler turning, const gpu::Image& radiance) const;
  /// Copies the picture; the last copy must have been executed.
  void upload(const gpu::Context& context, vk::CommandBuffer commands, const HostSky& sky) noexcept;
  /// 0 without a picture.
  std::uint32_t width() const noexcept { return width_; }
  /// Size of a radiance map that shows it as sharply as it is, and Pelagic's own sky.
  vk::Extent2D radianceExtent() const noexcept;

 private:
  std::uint32_t width_ = 0;
  gpu::Image image_;  ///< rgba16f, the sky's half.
  gpu::Buffer staging_;
};

/// Runs `step` of HostPicture::createStep() into `radiance`, the picture turned by `rotation` [rad]; the map then rests
/// in kShaderRead.
void recordHostSky(const gpu::Context& context, vk::CommandBuffer commands, const Step& step, gpu::Image& radiance,
                   double rotation) noexcept;

}  // namespace pelagic::sky
