#include <algorithm>
#include <bit>
#include <cmath>
#include <sky/clouds.hpp>

#include "sky_cloud_detail_comp.spv.hpp"
#include "sky_cloud_light_comp.spv.hpp"
#include "sky_cloud_shadow_comp.spv.hpp"
#include "sky_cloud_shape_comp.spv.hpp"

namespace pelagic::sky {
namespace {

using shader::CloudPass;
constexpr vk::Extent2D kCells(shader::kCloudCells, shader::kCloudCells);
constexpr std::uint32_t kGroups = shader::kCloudCells / shader::kSkyTile;
constexpr std::uint32_t kShadowMips = std::bit_width(shader::kCloudCells);

/// Standard normal value that a share `p` of all exceeds, by bisection: no part of <cmath> inverts erfc.
double upperQuantile(double p) {
  double low = -6, high = 6;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(middle / std::sqrt(2.0)) > p ? low : high) = middle;
  }
  return low;
}

}  // namespace

CloudPass cloudPassOf(const SkyState& state, const glm::vec3& light) noexcept {
  CloudPass pass{};
  pass.sunDirection = glm::vec4(light, 0);
  pass.base = static_cast<float>(state.clouds.base);
  pass.thickness = static_cast<float>(state.clouds.thickness);
  pass.threshold = static_cast<float>(std::clamp(upperQuantile(state.clouds.cover), -3.0, 3.0));
  // A closed layer has no open sea between its clouds.
  pass.openSea = std::clamp(1.5f * pass.threshold, 0.0f, 1.0f);
  // Of the noise's heights, of which a float tells 1024 apart, folded.
  pass.seed = (state.clouds.seed ^ (state.clouds.seed >> 10u) ^ (state.clouds.seed >> 20u)) & 1023u;
  return pass;
}

Result<Clouds> Clouds::create(gpu::Context& context, vk::Sampler repeat, vk::Sampler everywhere) {
  const auto sampled = vk::DescriptorType::eCombinedImageSampler, storage = vk::DescriptorType::eStorageImage;
  const auto half = vk::Format::eR16Sfloat;
  Clouds result;
  PELAGIC_TRY(field, createMap(context, "cloud field", kCells, 1, half, shader::kCloudLayers));
  PELAGIC_TRY(volume, createMap(context, "cloud volume", kCells, 1, vk::Format::eR16G16Sfloat, shader::kCloudLayers));
  PELAGIC_TRY(detail, createMap(context, "cloud detail", {shader::kCloudDetail, shader::kCloudDetail}, 1, half,
                                shader::kCloudDetail));
  PELAGIC_TRY(shadow, createMap(context, "cloud shadow", kCells, kShadowMips, vk::Format::eR16G16Sfloat));
  result.field_ = std::move(field);
  result.volume = std::move(volume);
  result.detail = std::move(detail);
  result.shadow = std::move(shadow);

  PELAGIC_TRY(shapeStep,
              createStep(context, "cloud shape", shaders::sky_cloud_shape_comp, {storage, sampled}, sizeof(CloudPass)));
  shapeStep.set.storageImage(0, result.field_.mipView(0));
  shapeStep.set.sampled(1, result.detail.view(), everywhere);
  PELAGIC_TRY(detailStep, createStep(context, "cloud detail", shaders::sky_cloud_detail_comp, {storage}, 0));
  detailStep.set.storageImage(0, result.detail.mipView(0));
  PELAGIC_TRY(lightStep,
              createStep(context, "cloud light", shaders::sky_cloud_light_comp, {sampled, storage}, sizeof(CloudPass)));
  lightStep.set.sampled(0, result.field_.view(), repeat);
  lightStep.set.storageImage(1, result.volume.mipView(0));
  PELAGIC_TRY(shadowStep, createStep(context, "cloud shadow", shaders::sky_cloud_shadow_comp,
                                     {sampled, storage, sampled}, sizeof(CloudPass)));
  shadowStep.set.sampled(0, result.field_.view(), repeat);
  shadowStep.set.storageImage(1, result.shadow.mipView(0));
  shadowStep.set.sampled(2, result.detail.view(), everywhere);
  result.shapeStep_ = std::move(shapeStep);
  result.detailStep_ = std::move(detailStep);
  result.lightStep_ = std::move(lightStep);
  result.shadowStep_ = std::move(shadowStep);

  PELAGIC_TRY(mips, MipChain::create(context, "cloud shadow mip", result.shadow, repeat));
  result.shadowMips_ = std::move(mips);
  return result;
}

void Clouds::recordShape(gpu::Context& context, vk::CommandBuffer commands, const CloudPass& push) noexcept {
  gpu::Barrier barrier;
  barrier.image(field_, gpu::kComputeStorageWrite, true);
  if (!detailed_) {
    barrier.image(detail, gpu::kComputeStorageWrite, true).record(context, commands);
    detailStep_.pass.bind(commands, detailStep_.set);
    constexpr std::uint32_t kDetailGroups = shader::kCloudDetail / shader::kSkyTile;
    detailStep_.pass.dispatch(commands, kDetailGroups, kDetailGroups, shader::kCloudDetail);
    barrier.image(detail, kShaderRead);
    detailed_ = true;
  }
  barrier.record(context, commands);
  shapeStep_.run(commands, push, kGroups, kGroups, shader::kCloudLayers);
  barrier.image(field_, gpu::kComputeSampled).record(context, commands);
}

void Clouds::record(gpu::Context& context, vk::CommandBuffer commands, const CloudPass& push, bool shape) noexcept {
  if (shape) recordShape(context, commands, push);
  gpu::Barrier barrier;
  barrier.image(volume, gpu::kComputeStorageWrite, true)
      .image(shadow, gpu::kComputeStorageWrite, true)
      .record(context, commands);
  lightStep_.run(commands, push, kGroups, kGroups, shader::kCloudLayers);
  shadowStep_.run(commands, push, kGroups, kGroups);
  barrier.image(volume, kShaderRead).record(context, commands);
  shadowMips_.record(context, commands, shadow);
}

void Clouds::recordNone(gpu::Context& context, vk::CommandBuffer commands) noexcept {
  clearMap(context, commands, shadow, {1, 1, 1, 1});
}

}  // namespace pelagic::sky
