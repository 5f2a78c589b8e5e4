#include <shared/sky_pass.h>

#include <bit>
#include <sky/environment.hpp>

#include "sky_environment_comp.spv.hpp"

namespace pelagic::sky {

constexpr std::uint32_t kMips = std::bit_width(shader::kEnvironmentSize);

Result<Environment> Environment::create(gpu::Context& context, const gpu::Image& radiance, vk::Sampler turning,
                                        vk::Sampler clamped, const gpu::Image* dome) {
  const auto sampled = vk::DescriptorType::eCombinedImageSampler, storage = vk::DescriptorType::eStorageImage;
  Environment result;
  PELAGIC_TRY(image,
              createMap(context, "sky environment", {shader::kEnvironmentSize, shader::kEnvironmentSize}, kMips));
  result.image = std::move(image);
  const std::uint32_t clouds[] = {dome != nullptr};
  PELAGIC_TRY(step, createStep(context, "sky environment", shaders::sky_environment_comp, {sampled, storage, sampled},
                               0, clouds));
  result.step_ = std::move(step);
  result.step_.set.sampled(0, radiance.view(), turning);
  result.step_.set.storageImage(1, result.image.mipView(0));
  result.step_.set.sampled(2, dome ? dome->view() : radiance.view(), clamped);

  PELAGIC_TRY(mips, MipChain::create(context, "sky environment mip", result.image, clamped));
  result.mips_ = std::move(mips);
  return result;
}

void Environment::record(gpu::Context& context, vk::CommandBuffer commands) noexcept {
  gpu::Barrier().image(image, gpu::kComputeStorageWrite, true).record(context, commands);
  step_.pass.bind(commands, step_.set);
  step_.pass.dispatch(commands, shader::kEnvironmentSize / shader::kSkyTile,
                      shader::kEnvironmentSize / shader::kSkyTile);
  mips_.record(context, commands, image);
}

}  // namespace pelagic::sky
