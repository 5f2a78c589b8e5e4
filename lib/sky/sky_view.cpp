#include <algorithm>
#include <limits>
#include <sky/sky_impl.hpp>

#include "physics/atmosphere.glsl"
#include "sky_clear_comp.spv.hpp"
#include "sky_radiance_comp.spv.hpp"

namespace pelagic {

struct SkyView::Impl {
  const Sky::Impl* sky = nullptr;
  gpu::Image clear, radiance;
  sky::Step clearStep, radianceStep;
  std::uint64_t version = 0;  ///< Of the sky's state in the maps; 0: none yet.
  double altitude = std::numeric_limits<double>::quiet_NaN();
};

SkyView::SkyView(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
SkyView::SkyView(SkyView&&) noexcept = default;
SkyView& SkyView::operator=(SkyView&&) noexcept = default;
SkyView::~SkyView() = default;

Result<SkyView> SkyView::create(const Sky& sky) {
  const Sky::Impl& air = *sky.impl_;
  gpu::Context& context = *air.context;
  auto impl = std::make_unique<Impl>();
  impl->sky = &air;
  PELAGIC_TRY(clear,
              sky::createMap(context, "sky view clear", shader::kClearSize, shader::kAirRows + shader::kClearSize));
  impl->clear = std::move(clear);
  PELAGIC_TRY(radiance, sky::createMap(context, "sky view radiance", shader::kRadianceWidth, shader::kRadianceHeight));
  impl->radiance = std::move(radiance);
  const auto sampled = vk::DescriptorType::eCombinedImageSampler, storage = vk::DescriptorType::eStorageImage,
             buffer = vk::DescriptorType::eStorageBuffer;
  PELAGIC_TRY(clearStep,
              sky::createStep(context, "sky view clear", shaders::sky_clear_comp, {sampled, buffer, storage}));
  impl->clearStep = std::move(clearStep);
  impl->clearStep.set.sampled(0, air.transmittance.view(), *air.clamped);
  impl->clearStep.set.buffer(1, air.scattering.handle());
  impl->clearStep.set.storageImage(2, impl->clear.mipView(0));
  PELAGIC_TRY(radianceStep,
              sky::createStep(context, "sky view radiance", shaders::sky_radiance_comp, {sampled, buffer, storage}));
  impl->radianceStep = std::move(radianceStep);
  impl->radianceStep.set.sampled(0, impl->clear.view(), *air.clamped);
  impl->radianceStep.set.buffer(1, air.light.handle());
  impl->radianceStep.set.storageImage(2, impl->radiance.mipView(0));
  return SkyView(std::move(impl));
}

void SkyView::record(VkCommandBuffer commandBuffer, double altitude, Timings* timings) noexcept {
  Impl& view = *impl_;
  // The densities' shortest scale is 1200 m: nothing changes within a metre, and below the sea the sky is that of its
  // level.
  const double height = std::clamp(std::round(altitude), 0.0, 0.99 * static_cast<double>(shader::kAirTop));
  if (view.version == view.sky->version && view.altitude == height) return;
  view.version = view.sky->version;
  view.altitude = height;
  const vk::CommandBuffer commands(commandBuffer);
  const shader::SkyPass push = sky::passOf(view.sky->state, height, shader::kAirRows);
  if (timings) timings->begin(commands, "sky view");
  gpu::Barrier barrier;
  barrier.image(view.clear, gpu::kComputeStorageWrite, true)
      .image(view.radiance, gpu::kComputeStorageWrite, true)
      .record(*view.sky->context, commands);
  view.clearStep.pass.bind(commands, view.clearStep.set);
  view.clearStep.pass.push(commands, push);
  view.clearStep.pass.dispatch(commands, shader::kClearSize / shader::kSkyTile,
                               (shader::kAirRows + shader::kClearSize) / shader::kSkyTile);
  barrier.image(view.clear, gpu::kComputeSampled).record(*view.sky->context, commands);
  view.radianceStep.pass.bind(commands, view.radianceStep.set);
  view.radianceStep.pass.push(commands, push);
  view.radianceStep.pass.dispatch(commands, shader::kRadianceWidth / shader::kSkyTile,
                                  shader::kRadianceHeight / shader::kSkyTile);
  barrier.image(view.radiance, kShaderRead).record(*view.sky->context, commands);
  if (timings) timings->end(commands);
}

SkyMaps SkyView::maps() const noexcept {
  const Sky::Impl& sky = *impl_->sky;
  return {impl_->radiance.map(), sky.environment.map(), sky.light.handle(), sky.light.size()};
}

}  // namespace pelagic
