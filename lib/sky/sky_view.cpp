#include <algorithm>
#include <cmath>
#include <limits>
#include <sky/sky_impl.hpp>

#include "pelagic/shader/sky_light.h"
#include "physics/atmosphere.glsl"
#include "physics/cloud_weather.glsl"
#include "sky_clear_comp.spv.hpp"
#include "sky_cloud_dome_comp.spv.hpp"
#include "sky_cloud_view_comp.spv.hpp"
#include "sky_radiance_comp.spv.hpp"
#include "sky_view_light_comp.spv.hpp"

namespace pelagic {

struct SkyView::Impl {
  const Sky::Impl* sky = nullptr;
  vk::Extent2D extent;  ///< Of the view.
  gpu::Image clear, moonlit, radiance, dome, clouds;
  gpu::Buffer light;
  sky::Step clearStep, moonStep, radianceStep, hostStep, domeStep, cloudStep, lightStep;
  sky::Environment environment;
  std::uint64_t version = 0;  ///< Of the sky's state in the maps; 0: none yet.
  double altitude = std::numeric_limits<double>::quiet_NaN();
  bool cleared = false;  ///< The picture of the clouds holds none.

  Result<void> createImages();
  Result<void> createAir();
  Result<void> createClouds();
  shader::CloudView cloudView(const Camera& camera) const noexcept;
  void recordAir(vk::CommandBuffer commands) noexcept;
  void recordClouds(vk::CommandBuffer commands, const shader::CloudView& push) noexcept;
  void recordLight(vk::CommandBuffer commands, const shader::CloudView& push) noexcept;
};

namespace {

using Type = vk::DescriptorType;

vk::Extent2D cloudExtent(vk::Extent2D view) {
  return {gpu::groups(view.width, shader::kCloudPixels), gpu::groups(view.height, shader::kCloudPixels)};
}

}  // namespace

SkyView::SkyView(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
SkyView::SkyView(SkyView&&) noexcept = default;
SkyView& SkyView::operator=(SkyView&&) noexcept = default;
SkyView::~SkyView() = default;

Result<SkyView> SkyView::create(const Sky& sky, VkExtent2D extent) {
  constexpr std::uint32_t kMost = 16384;
  if (extent.width < 1 || extent.height < 1 || extent.width > kMost || extent.height > kMost) {
    return gpu::reject("SkyView's extent is " + std::to_string(extent.width) + " x " + std::to_string(extent.height) +
                       ", it must be 1 to 16384 each");
  }
  auto impl = std::make_unique<Impl>();
  impl->sky = sky.impl_.get();
  impl->extent = extent;
  PELAGIC_CHECK(impl->createImages());
  PELAGIC_CHECK(impl->createAir());
  PELAGIC_CHECK(impl->createClouds());
  return SkyView(std::move(impl));
}

Result<void> SkyView::Impl::createImages() {
  gpu::Context& context = *sky->context;
  const auto image = [&](gpu::Image& target, std::string_view name, vk::Extent2D size) -> Result<void> {
    PELAGIC_TRY(created, sky::createMap(context, name, size));
    target = std::move(created);
    return {};
  };
  PELAGIC_CHECK(image(clear, "sky view clear", {shader::kClearSize, shader::kAirRows + shader::kClearSize}));
  PELAGIC_CHECK(image(moonlit, "sky view moonlit", {shader::kClearSize, shader::kAirRows + shader::kClearSize}));
  PELAGIC_CHECK(image(radiance, "sky view radiance", sky->hostPicture.radianceExtent()));
  PELAGIC_CHECK(image(dome, "sky view dome", {shader::kDomeSize, shader::kDomeSize}));
  PELAGIC_CHECK(image(clouds, "sky view clouds", cloudExtent(extent)));
  PELAGIC_TRY(block, sky::createLight(context, "sky view light"));
  light = std::move(block);
  return {};
}

Result<void> SkyView::Impl::createAir() {
  gpu::Context& context = *sky->context;
  const Type sampled = Type::eCombinedImageSampler, storage = Type::eStorageImage, buffer = Type::eStorageBuffer;
  const auto march = [&](sky::Step& target, std::string_view name, const gpu::Image& output) -> Result<void> {
    PELAGIC_TRY(step, sky::createStep(context, name, shaders::sky_clear_comp, {sampled, buffer, storage},
                                      sizeof(shader::SkyPass), sky::aroundPlanet(sky->planetRadius)));
    step.set.sampled(0, sky->transmittance.view(), *sky->clamped);
    step.set.buffer(1, sky->scattering.handle());
    step.set.storageImage(2, output.mipView(0));
    target = std::move(step);
    return {};
  };
  PELAGIC_CHECK(march(clearStep, "sky view clear", clear));
  PELAGIC_CHECK(march(moonStep, "sky view moonlit", moonlit));
  PELAGIC_TRY(step, sky::createStep(context, "sky view radiance", shaders::sky_radiance_comp,
                                    {sampled, buffer, storage, sampled}, sizeof(shader::SkyPass),
                                    sky::aroundPlanet(sky->planetRadius)));
  radianceStep = std::move(step);
  radianceStep.set.sampled(0, clear.view(), *sky->clamped);
  radianceStep.set.buffer(1, sky->light.handle());
  radianceStep.set.storageImage(2, radiance.mipView(0));
  radianceStep.set.sampled(3, moonlit.view(), *sky->clamped);
  PELAGIC_TRY(shown, sky->hostPicture.createStep(context, *sky->turning, radiance));
  hostStep = std::move(shown);
  return {};
}

Result<void> SkyView::Impl::createClouds() {
  gpu::Context& context = *sky->context;
  const Type sampled = Type::eCombinedImageSampler, storage = Type::eStorageImage, buffer = Type::eStorageBuffer;
  const auto create = [&](sky::Step& target, std::string_view name, std::span<const std::uint32_t> code,
                          const gpu::Image& air, const gpu::Image& output) -> Result<void> {
    PELAGIC_TRY(step, sky::createStep(context, name, code, {sampled, sampled, sampled, Type::eUniformBuffer, storage},
                                      sizeof(shader::CloudView), sky::aroundPlanet(sky->planetRadius)));
    step.set.sampled(0, sky->clouds.volume.view(), *sky->repeat);
    step.set.sampled(1, sky->clouds.detail.view(), *sky->repeatEverywhere);
    step.set.sampled(2, air.view(), *sky->turning);
    step.set.buffer(3, sky->light.handle());
    step.set.storageImage(4, output.mipView(0));
    target = std::move(step);
    return {};
  };
  PELAGIC_CHECK(create(domeStep, "sky view dome", shaders::sky_cloud_dome_comp, sky->radiance, dome));
  PELAGIC_CHECK(create(cloudStep, "sky view clouds", shaders::sky_cloud_view_comp, radiance, clouds));
  PELAGIC_TRY(filtered, sky::Environment::create(context, sky->radiance, *sky->turning, *sky->clamped, &dome));
  environment = std::move(filtered);
  PELAGIC_TRY(step, sky::createStep(context, "sky view light", shaders::sky_view_light_comp, {sampled, buffer, buffer},
                                    sizeof(shader::CloudView)));
  step.set.sampled(0, environment.image.view(), *sky->clamped);
  step.set.buffer(1, sky->light.handle());
  step.set.buffer(2, light.handle());
  lightStep = std::move(step);
  return {};
}

shader::CloudView SkyView::Impl::cloudView(const Camera& camera) const noexcept {
  const CloudLayer& layer = sky->recorded.state.clouds;
  const PixelRays rays = pixelRays(camera, extent);
  constexpr double kPixels = shader::kCloudPixels, kTile = static_cast<double>(shader::kCloudTile);
  shader::CloudView view{};
  view.ray = glm::vec4(glm::dvec4(rays.origin + 0.5 * (kPixels - 1) * (rays.right + rays.down), altitude));
  view.rayX = glm::vec4(glm::dvec4(kPixels * rays.right, layer.base));
  view.rayY = glm::vec4(glm::dvec4(kPixels * rays.down, layer.base + layer.thickness));
  // In double precision: eye and time may be far.
  const glm::dvec2 drift = layer.velocity * std::fmod(sky->time, kTile * 12e6);
  const glm::dvec2 place = (glm::dvec2(camera.position.x, camera.position.z) - drift) / kTile;
  constexpr double kWeather = physics::kCloudWeatherTiles;
  view.place = glm::vec2(place - kWeather * glm::floor(place / kWeather));
  view.edge = shader::horizonElevation(static_cast<float>(altitude), static_cast<float>(sky->planetRadius));
  view.cover = static_cast<float>(sky->cloudCover());
  view.width = clouds.info().extent.width;
  view.height = clouds.info().extent.height;
  view.openSea = sky::cloudPassOf(sky->recorded.state, {}).openSea;
  return view;
}

void SkyView::Impl::recordAir(vk::CommandBuffer commands) noexcept {
  const shader::SkyPass push = sky::passOf(sky->recorded.state, sky->planetRadius, altitude, shader::kAirRows);
  gpu::Barrier barrier;
  barrier.image(clear, gpu::kComputeStorageWrite, true)
      .image(radiance, gpu::kComputeStorageWrite, true)
      .record(*sky->context, commands);
  clearStep.run(commands, push, shader::kClearSize / shader::kSkyTile,
                (shader::kAirRows + shader::kClearSize) / shader::kSkyTile);
  barrier.image(clear, gpu::kComputeSampled).record(*sky->context, commands);
  sky::recordMoonlit(*sky->context, commands, moonStep, moonlit, push, shader::kAirRows + shader::kClearSize);
  const vk::Extent2D size = radiance.info().extent;
  radianceStep.run(commands, push, size.width / shader::kSkyTile, size.height / shader::kSkyTile);
  barrier.image(radiance, kShaderRead).record(*sky->context, commands);
}

void SkyView::Impl::recordClouds(vk::CommandBuffer commands, const shader::CloudView& push) noexcept {
  const gpu::Context& context = *sky->context;
  gpu::Barrier barrier;
  barrier.image(dome, gpu::kComputeStorageWrite, true)
      .image(clouds, gpu::kComputeStorageWrite, true)
      .record(context, commands);
  domeStep.run(commands, push, shader::kDomeSize / shader::kSkyTile, shader::kDomeSize / shader::kSkyTile);
  cloudStep.run(commands, push, gpu::groups(push.width, shader::kSkyTile), gpu::groups(push.height, shader::kSkyTile));
  barrier.image(dome, gpu::kComputeSampled).image(clouds, kShaderRead).record(context, commands);
  cleared = false;
}

void SkyView::Impl::recordLight(vk::CommandBuffer commands, const shader::CloudView& push) noexcept {
  environment.record(*sky->context, commands);
  gpu::Barrier().buffer(light, gpu::kComputeWrite).record(*sky->context, commands);
  lightStep.run(commands, push, 1);
  gpu::Barrier().buffer(light, sky::kLightRead).record(*sky->context, commands);
}

void SkyView::record(VkCommandBuffer commandBuffer, const Camera& camera, Timings* timings) noexcept {
  Impl& view = *impl_;
  const gpu::Context& context = *view.sky->context;
  const vk::CommandBuffer commands(commandBuffer);
  // The densities' shortest scale is 200 m: within a metre they change by half a percent, and below the sea the sky is
  // that of its level.
  constexpr double kHighest = 0.99 * static_cast<double>(shader::kAirTop);
  const double height = std::clamp(std::round(camera.position.y), 0.0, kHighest);
  const bool changed = view.version != view.sky->version, moved = changed || view.altitude != height;
  view.version = view.sky->version;
  view.altitude = height;
  const auto measured = [&](const char* name, const auto& pass) {
    if (timings) timings->begin(commandBuffer, name);
    pass();
    if (timings) timings->end(commandBuffer);
  };
  if (view.sky->recorded.hosted) {
    // The same from every altitude.
    const auto show = [&] {
      sky::recordHostSky(context, commands, view.hostStep, view.radiance, view.sky->recorded.rotation);
    };
    if (changed) measured("sky view", show);
  } else if (moved) {
    measured("sky view", [&] { view.recordAir(commands); });
  }
  const shader::CloudView push = view.cloudView(camera);
  if (view.sky->cloudy()) {
    measured("sky clouds", [&] { view.recordClouds(commands, push); });
  } else if (!view.cleared) {
    sky::clearMap(context, commands, view.dome, {0, 0, 0, 1});
    sky::clearMap(context, commands, view.clouds, {0, 0, 0, 1});
    view.cleared = true;
  }
  if (changed || view.sky->cloudy()) measured("sky view light", [&] { view.recordLight(commands, push); });
}

SkyMaps SkyView::maps() const noexcept {
  const Impl& view = *impl_;
  return {view.radiance.map(), view.environment.image.map(),  view.light.handle(),   view.light.size(),
          view.clouds.map(),   view.sky->clouds.shadow.map(), view.sky->planetRadius};
}

}  // namespace pelagic
