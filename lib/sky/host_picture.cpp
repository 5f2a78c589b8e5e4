#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <sky/host_picture.hpp>

#include "sky_host_sky_comp.spv.hpp"

namespace pelagic::sky {

Result<HostPicture> HostPicture::create(gpu::Context& context, const HostSky& sky) {
  HostPicture result;
  result.width_ = sky.width;
  if (sky.width == 0) return result;
  PELAGIC_TRY(image, createMap(context, "sky host picture", {sky.width, sky.rows}));
  result.image_ = std::move(image);
  const vk::DeviceSize bytes = sizeof(sky.texels[0]) * sky.width * sky.rows;
  PELAGIC_TRY(staging, gpu::Buffer::create(context, Stage::sky, "sky host picture staging", bytes,
                                           vk::BufferUsageFlagBits::eTransferSrc, gpu::Buffer::Placement::upload));
  result.staging_ = std::move(staging);
  return result;
}

Result<Step> HostPicture::createStep(gpu::Context& context, vk::Sampler turning, const gpu::Image& radiance) const {
  if (width_ == 0) return Step{};
  PELAGIC_TRY(step, sky::createStep(context, "sky host sky", shaders::sky_host_sky_comp,
                                    {vk::DescriptorType::eCombinedImageSampler, vk::DescriptorType::eStorageImage},
                                    sizeof(shader::HostSkyPass)));
  step.set.sampled(0, image_.view(), turning);
  step.set.storageImage(1, radiance.mipView(0));
  return step;
}

void HostPicture::upload(const gpu::Context& context, vk::CommandBuffer commands, const HostSky& sky) noexcept {
  std::memcpy(staging_.mapped(), sky.texels.data(), sizeof(sky.texels[0]) * sky.texels.size());
  gpu::Barrier().image(image_, gpu::kTransferDestination, true).record(context, commands);
  commands.copyBufferToImage(
      staging_.handle(), image_.handle(), vk::ImageLayout::eTransferDstOptimal,
      vk::BufferImageCopy(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {}, {sky.width, sky.rows, 1}),
      context.dispatch);
  gpu::Barrier().image(image_, gpu::kComputeSampled).record(context, commands);
}

vk::Extent2D HostPicture::radianceExtent() const noexcept {
  const auto whole = [](std::uint32_t size) { return gpu::groups(size, shader::kSkyTile) * shader::kSkyTile; };
  return {std::max(shader::kRadianceWidth, whole(width_)), std::max(shader::kRadianceHeight, whole(width_ / 2))};
}

void recordHostSky(const gpu::Context& context, vk::CommandBuffer commands, const Step& step, gpu::Image& radiance,
                   double rotation) noexcept {
  gpu::Barrier().image(radiance, gpu::kComputeStorageWrite, true).record(context, commands);
  const double turns = rotation / (2 * std::numbers::pi);
  shader::HostSkyPass push{};
  push.turn = static_cast<float>(turns - std::floor(turns));
  const vk::Extent2D extent = radiance.info().extent;
  step.run(commands, push, extent.width / shader::kSkyTile, extent.height / shader::kSkyTile);
  gpu::Barrier().image(radiance, kShaderRead).record(context, commands);
}

}  // namespace pelagic::sky
