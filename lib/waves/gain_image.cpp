#include <cstring>
#include <waves/gain_image.hpp>

namespace pelagic {
namespace {

constexpr ImageState kImageWrite{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};

}  // namespace

Result<GainImage> GainImage::create(gpu::Context& context, const WavesInfo& info) {
  GainImage result;
  result.context_ = &context;
  if (info.gain.width == 0) return result;
  gpu::ImageInfo image;
  image.format = vk::Format::eR32Sfloat;
  image.extent = vk::Extent2D(info.gain.width, info.gain.height);
  image.layers = info.layout.count;
  image.array = true;
  using Usage = vk::ImageUsageFlagBits;
  image.usage = Usage::eSampled | Usage::eTransferDst | Usage::eTransferSrc;
  PELAGIC_TRY(made, gpu::Image::create(context, Stage::waves, "waves gain", image));
  result.image_ = std::move(made);
  const vk::DeviceSize bytes = sizeof(float) * info.gain.width * info.gain.height * info.layout.count;
  for (std::uint32_t i = 0; i < info.framesInFlight; ++i) {
    PELAGIC_TRY(staging, gpu::Buffer::create(context, Stage::waves, "waves gain staging " + std::to_string(i), bytes,
                                             vk::BufferUsageFlagBits::eTransferSrc, gpu::Buffer::Placement::upload));
    result.staging_.push_back(std::move(staging));
  }
  return result;
}

void GainImage::upload(vk::CommandBuffer commands, const GainMap& map, std::uint32_t slot) noexcept {
  if (staging_.empty()) return;
  const gpu::Buffer& staging = staging_[slot];
  const gpu::ImageInfo& info = image_.info();
  const std::size_t band = sizeof(float) * map.width * map.height;
  for (std::uint32_t layer = 0; layer < info.layers; ++layer) {
    const std::size_t source = map.bands == 1 ? 0 : layer;
    std::memcpy(static_cast<std::byte*>(staging.mapped()) + layer * band,
                reinterpret_cast<const std::byte*>(map.gains.data()) + source * band, band);
  }
  gpu::Barrier().image(image_, kImageWrite, true).record(*context_, commands);
  commands.copyBufferToImage(staging.handle(), image_.handle(), vk::ImageLayout::eTransferDstOptimal,
                             vk::BufferImageCopy(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, info.layers}, {},
                                                 {info.extent.width, info.extent.height, 1}),
                             context_->dispatch);
  gpu::Barrier().image(image_, kShaderRead).record(*context_, commands);
}

}  // namespace pelagic
