#include <algorithm>
#include <cmath>
#include <composite/targets.hpp>
#include <composite/white_balance.hpp>
#include <gpu/barrier.hpp>
#include <gpu/compute_pass.hpp>
#include <gpu/field.hpp>

#include "composite_meter_comp.spv.hpp"
#include "composite_tone_map_comp.spv.hpp"

namespace pelagic {

struct ToneMap::Impl {
  gpu::Context* context;
  HostImage input;
  HostImage output;
  gpu::Unique<vk::Sampler> sampler;
  gpu::Buffer gain;  ///< One float, 2^EV.
  gpu::ComputePass meter, pass;
  gpu::DescriptorSet meterSet, set;
  glm::mat3x4 whiteBalance{1};

  /// `setGain` records what writes the gain, in the state `written`.
  template <class SetGain>
  void record(vk::CommandBuffer commands, Timings* timings, const gpu::BufferState& written,
              const SetGain& setGain) noexcept;
};

ToneMap::ToneMap(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
ToneMap::ToneMap(ToneMap&&) noexcept = default;
ToneMap& ToneMap::operator=(ToneMap&&) noexcept = default;
ToneMap::~ToneMap() = default;

Result<ToneMap> ToneMap::create(Device& device, const ToneMapInfo& info) {
  PELAGIC_CHECK(validate(info));
  gpu::Context& context = device.context();
  const auto sampled = vk::DescriptorType::eCombinedImageSampler, buffer = vk::DescriptorType::eStorageBuffer;
  PELAGIC_TRY(sampler,
              gpu::createSampler(context, "tone map", {vk::Filter::eNearest, vk::SamplerMipmapMode::eNearest}));
  PELAGIC_TRY(gain,
              gpu::Buffer::create(context, Stage::composite, "exposure", sizeof(float),
                                  vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eTransferDst));
  const gpu::Binding meterBindings[] = {{0, sampled}, {1, buffer}};
  PELAGIC_TRY(meter, gpu::ComputePass::create(
                         context, {"meter", shaders::composite_meter_comp, meterBindings, sizeof(float), {}}));
  PELAGIC_TRY(meterSet, meter.createSet("meter"));
  meterSet.sampled(0, info.input.view, *sampler);
  meterSet.buffer(1, gain.handle());
  const gpu::Binding bindings[] = {{0, sampled}, {1, vk::DescriptorType::eStorageImage}, {2, buffer}};
  PELAGIC_TRY(pass, gpu::ComputePass::create(
                        context, {"tone map", shaders::composite_tone_map_comp, bindings, sizeof(glm::mat3x4), {}}));
  PELAGIC_TRY(set, pass.createSet("tone map"));
  set.sampled(0, info.input.view, *sampler);
  set.storageImage(1, info.output.view);
  set.buffer(2, gain.handle());
  return ToneMap(std::make_unique<Impl>(Impl{&context, info.input, info.output, std::move(sampler), std::move(gain),
                                             std::move(meter), std::move(pass), std::move(meterSet), std::move(set)}));
}

template <class SetGain>
void ToneMap::Impl::record(vk::CommandBuffer commands, Timings* timings, const gpu::BufferState& written,
                           const SetGain& setGain) noexcept {
  const auto aspect = vk::ImageAspectFlagBits::eColor;
  ImageState unread = output.before;
  unread.layout = VK_IMAGE_LAYOUT_UNDEFINED;
  if (timings) timings->begin(commands, "tone map");
  gpu::Barrier()
      .image(input.image, aspect, input.before, gpu::kComputeSampled)
      .image(output.image, aspect, unread, gpu::kComputeStorageWrite)
      .buffer(gain, written)
      .record(*context, commands);
  setGain();
  gpu::Barrier().buffer(gain, gpu::kComputeRead).record(*context, commands);
  pass.bind(commands, set);
  pass.push(commands, whiteBalance);
  pass.dispatch(commands, gpu::groups(output.extent.width, 8), gpu::groups(output.extent.height, 8));
  gpu::Barrier()
      .image(input.image, aspect, gpu::kComputeSampled, input.after)
      .image(output.image, aspect, gpu::kComputeStorageWrite, output.after)
      .record(*context, commands);
  if (timings) timings->end(commands);
}

Result<void> ToneMap::setWhiteBalance(double kelvin) {
  PELAGIC_CHECK(gpu::check("", {{"white balance", kelvin, 2000, 25000, "2000 to 25000 K"}}));
  impl_->whiteBalance = glm::mat3x4(glm::transpose(whiteBalance(kelvin)));
  return {};
}

void ToneMap::record(VkCommandBuffer commandBuffer, float exposure, Timings* timings) noexcept {
  const vk::CommandBuffer commands(commandBuffer);
  impl_->record(commands, timings, gpu::kTransferWrite, [&] {
    const float gain = std::exp2(std::clamp(exposure, -32.0f, 32.0f));
    commands.updateBuffer(impl_->gain.handle(), 0, sizeof(gain), &gain, impl_->context->dispatch);
  });
}

void ToneMap::recordMetered(VkCommandBuffer commandBuffer, float compensation, Timings* timings) noexcept {
  const vk::CommandBuffer commands(commandBuffer);
  impl_->record(commands, timings, gpu::kComputeWrite, [&] {
    impl_->meter.bind(commands, impl_->meterSet);
    impl_->meter.push(commands, std::clamp(compensation, -32.0f, 32.0f));
    impl_->meter.dispatch(commands, 1);
  });
}

}  // namespace pelagic
