#include <cassert>
#include <gpu/barrier.hpp>

namespace pelagic::gpu {
namespace {

vk::ImageMemoryBarrier2 transition(vk::Image image, const vk::ImageSubresourceRange& range, const ImageState& before,
                                   const ImageState& after) noexcept {
  return {vk::PipelineStageFlags2(before.stages),
          vk::AccessFlags2(before.access),
          vk::PipelineStageFlags2(after.stages),
          vk::AccessFlags2(after.access),
          vk::ImageLayout(before.layout),
          vk::ImageLayout(after.layout),
          VK_QUEUE_FAMILY_IGNORED,
          VK_QUEUE_FAMILY_IGNORED,
          image,
          range};
}

}  // namespace

Barrier& Barrier::image(Image& image, const ImageState& next, bool discard) noexcept {
  assert(imageCount_ < kCapacity);
  ImageState before = image.state;
  if (discard) before.layout = VK_IMAGE_LAYOUT_UNDEFINED;
  images_[imageCount_++] = transition(image.handle(), image.range(), before, next);
  image.state = next;
  return *this;
}

Barrier& Barrier::buffer(Buffer& buffer, const BufferState& next) noexcept {
  assert(bufferCount_ < kCapacity);
  buffers_[bufferCount_++] =
      vk::BufferMemoryBarrier2(buffer.state.stages, buffer.state.access, next.stages, next.access,
                               VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, buffer.handle(), 0, VK_WHOLE_SIZE);
  buffer.state = next;
  return *this;
}

Barrier& Barrier::image(vk::Image image, vk::ImageAspectFlags aspect, const ImageState& before,
                        const ImageState& after) noexcept {
  assert(imageCount_ < kCapacity);
  images_[imageCount_++] =
      transition(image, {aspect, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS}, before, after);
  return *this;
}

Barrier& Barrier::mip(const Image& image, std::uint32_t mip, const ImageState& before,
                      const ImageState& after) noexcept {
  assert(imageCount_ < kCapacity);
  auto range = image.range();
  range.baseMipLevel = mip;
  range.levelCount = 1;
  images_[imageCount_++] = transition(image.handle(), range, before, after);
  return *this;
}

void Barrier::record(const Context& context, vk::CommandBuffer commands) noexcept {
  if (imageCount_ + bufferCount_ == 0) return;
  vk::DependencyInfo info;
  info.imageMemoryBarrierCount = imageCount_;
  info.pImageMemoryBarriers = images_.data();
  info.bufferMemoryBarrierCount = bufferCount_;
  info.pBufferMemoryBarriers = buffers_.data();
  commands.pipelineBarrier2(info, context.dispatch);
  imageCount_ = bufferCount_ = 0;
}

}  // namespace pelagic::gpu
