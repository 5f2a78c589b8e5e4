#include <shared/sky_pass.h>

#include <bit>
#include <gpu/barrier.hpp>
#include <sky/environment.hpp>

#include "sky_environment_comp.spv.hpp"
#include "sky_environment_mip_comp.spv.hpp"

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

  const gpu::Binding bindings[] = {{0, sampled, 1}, {1, storage, 1}};
  PELAGIC_TRY(mip, gpu::ComputePass::create(
                       context, {"sky environment mip", shaders::sky_environment_mip_comp, bindings, 0, {}}));
  result.mipPass_ = std::move(mip);
  for (std::uint32_t i = 0; i + 1 < kMips; ++i) {
    PELAGIC_TRY(set, result.mipPass_.createSet("sky environment mip"));
    set.sampled(0, result.image.mipView(i), clamped);
    set.storageImage(1, result.image.mipView(i + 1));
    result.mipSets_.push_back(std::move(set));
  }
  return result;
}

void Environment::record(gpu::Context& context, vk::CommandBuffer commands) noexcept {
  gpu::Barrier barrier;
  barrier.image(image, gpu::kComputeStorageWrite, true).record(context, commands);
  step_.pass.bind(commands, step_.set);
  step_.pass.dispatch(commands, shader::kEnvironmentSize / shader::kSkyTile,
                      shader::kEnvironmentSize / shader::kSkyTile);
  for (std::uint32_t i = 0; i < kMips; ++i) {
    barrier.mip(image, i, gpu::kComputeStorageWrite, kShaderRead).record(context, commands);
    if (i + 1 == kMips) break;
    mipPass_.bind(commands, mipSets_[i]);
    const std::uint32_t tiles = gpu::groups(shader::kEnvironmentSize >> (i + 1), shader::kSkyTile);
    mipPass_.dispatch(commands, tiles, tiles);
  }
  image.state = kShaderRead;
}

}  // namespace pelagic::sky
