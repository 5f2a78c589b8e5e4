#include <algorithm>
#include <cmath>
#include <composite/targets.hpp>
#include <gpu/barrier.hpp>
#include <gpu/compute_pass.hpp>

#include "composite_tone_map_comp.spv.hpp"

namespace pelagic {

struct ToneMap::Impl {
  gpu::Context* context;
  HostImage input;
  HostImage output;
  gpu::Unique<vk::Sampler> sampler;
  gpu::ComputePass pass;
  gpu::DescriptorSet set;
};

ToneMap::ToneMap(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
ToneMap::ToneMap(ToneMap&&) noexcept = default;
ToneMap& ToneMap::operator=(ToneMap&&) noexcept = default;
ToneMap::~ToneMap() = default;

Result<ToneMap> ToneMap::create(Device& device, const ToneMapInfo& info) {
  PELAGIC_CHECK(validate(info));
  gpu::Context& context = device.context();
  PELAGIC_TRY(sampler,
              gpu::createSampler(context, "tone map", {vk::Filter::eNearest, vk::SamplerMipmapMode::eNearest}));
  const gpu::Binding bindings[] = {{0, vk::DescriptorType::eCombinedImageSampler},
                                   {1, vk::DescriptorType::eStorageImage}};
  PELAGIC_TRY(pass, gpu::ComputePass::create(
                        context, {"tone map", shaders::composite_tone_map_comp, bindings, sizeof(float), {}}));
  PELAGIC_TRY(set, pass.createSet("tone map"));
  set.sampled(0, info.input.view, *sampler);
  set.storageImage(1, info.output.view);
  return ToneMap(std::make_unique<Impl>(
      Impl{&context, info.input, info.output, std::move(sampler), std::move(pass), std::move(set)}));
}

void ToneMap::record(VkCommandBuffer commandBuffer, float exposure, Timings* timings) noexcept {
  const vk::CommandBuffer commands(commandBuffer);
  const gpu::Context& context = *impl_->context;
  const auto aspect = vk::ImageAspectFlagBits::eColor;
  ImageState unread = impl_->output.before;
  unread.layout = VK_IMAGE_LAYOUT_UNDEFINED;
  if (timings) timings->begin(commands, "tone map");
  gpu::Barrier()
      .image(impl_->input.image, aspect, impl_->input.before, gpu::kComputeSampled)
      .image(impl_->output.image, aspect, unread, gpu::kComputeStorageWrite)
      .record(context, commands);
  impl_->pass.bind(commands, impl_->set);
  impl_->pass.push(commands, std::exp2(std::clamp(exposure, -32.0f, 32.0f)));
  impl_->pass.dispatch(commands, gpu::groups(impl_->output.extent.width, 8),
                       gpu::groups(impl_->output.extent.height, 8));
  gpu::Barrier()
      .image(impl_->input.image, aspect, gpu::kComputeSampled, impl_->input.after)
      .image(impl_->output.image, aspect, gpu::kComputeStorageWrite, impl_->output.after)
      .record(context, commands);
  if (timings) timings->end(commands);
}

}  // namespace pelagic
