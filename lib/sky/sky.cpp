#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <gpu/field.hpp>
#include <numbers>
#include <sky/sky_impl.hpp>

#include "pelagic/shader/sky_light.h"
#include "physics/atmosphere.glsl"
#include "physics/moon.glsl"
#include "sky_clear_comp.spv.hpp"
#include "sky_light_comp.spv.hpp"
#include "sky_radiance_comp.spv.hpp"
#include "sky_scattering_comp.spv.hpp"
#include "sky_transmittance_comp.spv.hpp"

namespace pelagic {
namespace sky {

glm::vec3 toward(double elevation, double azimuth) noexcept {
  const double side = std::cos(elevation);
  return glm::vec3(glm::dvec3(side * std::cos(azimuth), std::sin(elevation), side * std::sin(azimuth)));
}

bool moonCastsShadows(const SkyState& state) noexcept {
  return state.sunElevation < -kMoonTakesOver && moonlight(state) > 0;
}

double moonlight(const SkyState& state) noexcept {
  const bool up = state.moonElevation > -kSunAngularRadius;
  return up ? static_cast<double>(physics::moonStrength(static_cast<float>(state.moonIlluminated))) : 0;
}

shader::SkyPass passOf(const SkyState& state, double planetRadius, double altitude, std::uint32_t airRows) noexcept {
  shader::SkyPass pass{};
  pass.sunDirection = glm::vec4(toward(state.sunElevation, state.sunAzimuth), static_cast<float>(state.sunElevation));
  pass.sunAzimuth = static_cast<float>(std::remainder(state.sunAzimuth, 2 * std::numbers::pi));
  pass.overcast = static_cast<float>(state.overcast);
  pass.haze = glm::vec2(state.haze, state.hazeHeight);
  pass.gain = static_cast<float>(twilightGain(state.sunElevation));
  pass.altitude = static_cast<float>(altitude);
  pass.edge = shader::horizonElevation(pass.altitude, static_cast<float>(planetRadius));
  pass.airRows = airRows;
  pass.moonAzimuth = static_cast<float>(std::remainder(state.moonAzimuth, 2 * std::numbers::pi));
  pass.moonDirection = glm::vec4(toward(state.moonElevation, state.moonAzimuth), static_cast<float>(moonlight(state)));
  pass.sunPlace = glm::vec4(glm::vec3(pass.sunDirection), moonCastsShadows(state) ? 1 : 0);
  const glm::dquat stars = glm::quat_cast(glm::transpose(state.starsToWorld));
  pass.stars = glm::vec4(glm::dvec4(stars.x, stars.y, stars.z, stars.w));
  pass.night = 1;
  return pass;
}

namespace {

/// The same sky, lit by the moon alone.
shader::SkyPass moonPassOf(shader::SkyPass pass) noexcept {
  pass.sunDirection = pass.moonDirection;
  pass.sunAzimuth = pass.moonAzimuth;
  pass.gain *= pass.moonDirection.w;
  pass.night = 0;
  return pass;
}

}  // namespace

void recordMoonlit(const gpu::Context& context, vk::CommandBuffer commands, Step& step, gpu::Image& image,
                   const shader::SkyPass& push, std::uint32_t rows) noexcept {
  if (push.moonDirection.w > 0) {
    gpu::Barrier().image(image, gpu::kComputeStorageWrite, true).record(context, commands);
    step.run(commands, moonPassOf(push), shader::kClearSize / shader::kSkyTile, rows / shader::kSkyTile);
    gpu::Barrier().image(image, kShaderRead).record(context, commands);
  } else {
    clearMap(context, commands, image, {0, 0, 0, 0});
  }
}

Result<gpu::Buffer> createLight(gpu::Context& context, std::string_view name) {
  using Usage = vk::BufferUsageFlagBits;
  return gpu::Buffer::create(context, Stage::sky, name, sizeof(shader::SkyLight),
                             Usage::eStorageBuffer | Usage::eUniformBuffer | Usage::eTransferSrc | Usage::eTransferDst);
}

}  // namespace sky

Result<void> Sky::Impl::createResources() {
  const auto image = [&](gpu::Image& target, std::string_view name, vk::Extent2D extent) -> Result<void> {
    PELAGIC_TRY(created, sky::createMap(*context, name, extent));
    target = std::move(created);
    return {};
  };
  PELAGIC_CHECK(image(transmittance, "sky transmittance", {shader::kTransmittanceWidth, shader::kTransmittanceHeight}));
  PELAGIC_CHECK(image(clear, "sky clear", {shader::kClearSize, shader::kClearSize}));
  PELAGIC_CHECK(image(moonlit, "sky moonlit", {shader::kClearSize, shader::kClearSize}));
  PELAGIC_CHECK(image(radiance, "sky radiance", {shader::kRadianceWidth, shader::kRadianceHeight}));
  PELAGIC_TRY(scatteringBuffer,
              gpu::Buffer::create(*context, Stage::sky, "sky scattering",
                                  sizeof(glm::vec4) * shader::kScatteringWidth * shader::kScatteringHeight,
                                  vk::BufferUsageFlagBits::eStorageBuffer));
  scattering = std::move(scatteringBuffer);
  PELAGIC_TRY(lightBuffer, sky::createLight(*context, "sky light"));
  light = std::move(lightBuffer);
  gpu::SamplerInfo info;
  PELAGIC_TRY(repeatSampler, gpu::createSampler(*context, "sky repeat", info));
  repeat = std::move(repeatSampler);
  info.w = vk::SamplerAddressMode::eRepeat;
  PELAGIC_TRY(everywhereSampler, gpu::createSampler(*context, "sky repeat everywhere", info));
  repeatEverywhere = std::move(everywhereSampler);
  info.v = vk::SamplerAddressMode::eClampToEdge;
  PELAGIC_TRY(turningSampler, gpu::createSampler(*context, "sky turning", info));
  turning = std::move(turningSampler);
  info.u = vk::SamplerAddressMode::eClampToEdge;
  PELAGIC_TRY(clampedSampler, gpu::createSampler(*context, "sky clamped", info));
  clamped = std::move(clampedSampler);
  return {};
}

Result<void> Sky::Impl::createSteps() {
  using Type = vk::DescriptorType;
  const auto create = [&](sky::Step& target, std::string_view name, std::span<const std::uint32_t> code,
                          std::initializer_list<Type> types) -> Result<void> {
    PELAGIC_TRY(step,
                sky::createStep(*context, name, code, types, sizeof(shader::SkyPass), sky::aroundPlanet(planetRadius)));
    target = std::move(step);
    return {};
  };
  const Type sampled = Type::eCombinedImageSampler, storage = Type::eStorageImage, buffer = Type::eStorageBuffer;
  PELAGIC_CHECK(create(transmittanceStep, "sky transmittance", shaders::sky_transmittance_comp, {storage}));
  transmittanceStep.set.storageImage(0, transmittance.mipView(0));
  PELAGIC_CHECK(create(scatteringStep, "sky scattering", shaders::sky_scattering_comp, {sampled, buffer}));
  scatteringStep.set.sampled(0, transmittance.view(), *clamped);
  scatteringStep.set.buffer(1, scattering.handle());
  PELAGIC_CHECK(create(clearStep, "sky clear", shaders::sky_clear_comp, {sampled, buffer, storage}));
  clearStep.set.sampled(0, transmittance.view(), *clamped);
  clearStep.set.buffer(1, scattering.handle());
  clearStep.set.storageImage(2, clear.mipView(0));
  PELAGIC_CHECK(create(moonStep, "sky moonlit", shaders::sky_clear_comp, {sampled, buffer, storage}));
  moonStep.set.sampled(0, transmittance.view(), *clamped);
  moonStep.set.buffer(1, scattering.handle());
  moonStep.set.storageImage(2, moonlit.mipView(0));
  PELAGIC_CHECK(create(lightStep, "sky light", shaders::sky_light_comp, {sampled, buffer, sampled}));
  lightStep.set.sampled(0, clear.view(), *clamped);
  lightStep.set.buffer(1, light.handle());
  lightStep.set.sampled(2, moonlit.view(), *clamped);
  PELAGIC_CHECK(create(radianceStep, "sky radiance", shaders::sky_radiance_comp, {sampled, buffer, storage, sampled}));
  radianceStep.set.sampled(0, clear.view(), *clamped);
  radianceStep.set.buffer(1, light.handle());
  radianceStep.set.storageImage(2, radiance.mipView(0));
  radianceStep.set.sampled(3, moonlit.view(), *clamped);
  PELAGIC_TRY(filtered, sky::Environment::create(*context, radiance, *turning, *clamped, nullptr));
  environment = std::move(filtered);
  PELAGIC_TRY(layer, sky::Clouds::create(*context, *repeat, *repeatEverywhere));
  clouds = std::move(layer);
  PELAGIC_TRY(picture, sky::HostPicture::create(*context, hostSky));
  hostPicture = std::move(picture);
  PELAGIC_TRY(shown, hostPicture.createStep(*context, *turning, radiance));
  hostStep = std::move(shown);
  return {};
}

void Sky::Impl::recordAir(vk::CommandBuffer commands, const shader::SkyPass& push, Timings* timings) noexcept {
  if (timings) timings->begin(commands, "sky air");
  gpu::Barrier barrier;
  barrier.image(transmittance, gpu::kComputeStorageWrite, true)
      .buffer(scattering, gpu::kComputeWrite)
      .record(*context, commands);
  transmittanceStep.run(commands, push, shader::kTransmittanceWidth / shader::kSkyTile,
                        shader::kTransmittanceHeight / shader::kSkyTile);
  barrier.image(transmittance, gpu::kComputeSampled).record(*context, commands);
  scatteringStep.run(commands, push, shader::kScatteringWidth, shader::kScatteringHeight);
  barrier.buffer(scattering, gpu::kComputeRead).record(*context, commands);
  if (timings) timings->end(commands);
}

void Sky::Impl::recordRadiance(vk::CommandBuffer commands, const shader::SkyPass& push, Timings* timings) noexcept {
  if (timings) timings->begin(commands, "sky radiance");
  gpu::Barrier barrier;
  barrier.image(clear, gpu::kComputeStorageWrite, true)
      .image(radiance, gpu::kComputeStorageWrite, true)
      .buffer(light, gpu::kComputeWrite)
      .record(*context, commands);
  clearStep.run(commands, push, shader::kClearSize / shader::kSkyTile, shader::kClearSize / shader::kSkyTile);
  barrier.image(clear, gpu::kComputeSampled).record(*context, commands);
  sky::recordMoonlit(*context, commands, moonStep, moonlit, push, shader::kClearSize);
  // The sun that the clouds see is that of their middle.
  lightStep.run(commands, sky::passOf(state, planetRadius, state.clouds.base + 0.5 * state.clouds.thickness, 0), 1);
  barrier.buffer(light, sky::kLightRead).record(*context, commands);
  radianceStep.run(commands, push, shader::kRadianceWidth / shader::kSkyTile,
                   shader::kRadianceHeight / shader::kSkyTile);
  barrier.image(radiance, kShaderRead).record(*context, commands);
  if (timings) timings->end(commands);
}

/// The picture in place of air and radiance.
void Sky::Impl::recordHost(vk::CommandBuffer commands, Timings* timings) noexcept {
  if (timings) timings->begin(commands, "sky radiance");
  if (hostChanged) hostPicture.upload(*context, commands, hostSky);
  hostChanged = false;
  sky::recordHostSky(*context, commands, hostStep, radiance, hostSky.rotation);
  const shader::SkyLight block = sky::hostLight(hostSky, state);
  gpu::Barrier().buffer(light, gpu::kTransferWrite).record(*context, commands);
  commands.updateBuffer(light.handle(), 0, sizeof(block), &block, context->dispatch);
  gpu::Barrier().buffer(light, sky::kLightRead).record(*context, commands);
  if (timings) timings->end(commands);
}

void Sky::Impl::recordEnvironment(vk::CommandBuffer commands, Timings* timings) noexcept {
  if (timings) timings->begin(commands, "sky environment");
  environment.record(*context, commands);
  if (timings) timings->end(commands);
}

void Sky::Impl::recordClouds(vk::CommandBuffer commands, Timings* timings) noexcept {
  if (!cloudy()) return clouds.recordNone(*context, commands);
  if (timings) timings->begin(commands, "sky cloud volume");
  const glm::vec3 source = sky::moonCastsShadows(state) ? sky::toward(state.moonElevation, state.moonAzimuth)
                                                        : sky::toward(state.sunElevation, state.sunAzimuth);
  clouds.record(*context, commands, sky::cloudPassOf(state, source), cloudsChanged);
  cloudsChanged = false;
  if (timings) timings->end(commands);
}

Sky::Sky(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
Sky::Sky(Sky&&) noexcept = default;
Sky& Sky::operator=(Sky&&) noexcept = default;
Sky::~Sky() = default;

Result<Sky> Sky::create(Device& device, const SkyState& state, double planetRadius, const SkyEnvironment& environment) {
  PELAGIC_CHECK(validate(state));
  PELAGIC_CHECK(validate(environment));
  PELAGIC_CHECK(
      gpu::check("Sky's ", {{"planetRadius", planetRadius, kLeastPlanetRadius, kMostPlanetRadius, "1e5 to 1e8 m"}}));
  auto impl = std::make_unique<Impl>();
  impl->context = &device.context();
  impl->state = state;
  impl->planetRadius = planetRadius;
  impl->hostSky = sky::hostSky(environment);
  PELAGIC_CHECK(impl->createResources());
  PELAGIC_CHECK(impl->createSteps());
  return Sky(std::move(impl));
}

Result<void> Sky::setState(const SkyState& state) {
  PELAGIC_CHECK(validate(state));
  SkyState& now = impl_->state;
  const bool hazier = state.haze != now.haze || state.hazeHeight != now.hazeHeight;
  impl_->airChanged |= hazier;
  // Clouds drift without being computed again.
  CloudLayer moved = now.clouds;
  moved.velocity = state.clouds.velocity;
  impl_->cloudsChanged |= state.clouds != moved;
  const bool lit = state.sunElevation != now.sunElevation || state.sunAzimuth != now.sunAzimuth ||
                   state.overcast != now.overcast || state.clouds != moved ||
                   state.moonElevation != now.moonElevation || state.moonAzimuth != now.moonAzimuth ||
                   state.moonIlluminated != now.moonIlluminated || state.starsToWorld != now.starsToWorld;
  impl_->changed |= hazier || (lit && !impl_->hosted());
  now = state;
  return {};
}

Result<void> Sky::setEnvironment(const SkyEnvironment& environment) {
  PELAGIC_CHECK(validate(environment));
  const std::uint32_t width = impl_->hostPicture.width();
  if (environment.width != 0 && environment.width != width) {
    return gpu::reject("SkyEnvironment::width is " + std::to_string(environment.width) + ", it must be " +
                       (width == 0 ? "" : std::to_string(width) + " as at create(), or ") + "0" +
                       (width == 0 ? ": Sky::create() was given no picture" : ""));
  }
  impl_->hostSky = sky::hostSky(environment);
  impl_->hostChanged = impl_->changed = true;
  return {};
}

void Sky::record(VkCommandBuffer commands, double time, Timings* timings) noexcept {
  impl_->time = time;
  impl_->recorded = {impl_->state, impl_->hosted(), impl_->hostSky.rotation};
  if (!impl_->changed) return;
  if (impl_->hosted()) {
    impl_->recordHost(commands, timings);
  } else {
    const shader::SkyPass push = sky::passOf(impl_->state, impl_->planetRadius, 0, 0);
    if (impl_->airChanged) impl_->recordAir(commands, push, timings);
    impl_->recordRadiance(commands, push, timings);
    impl_->airChanged = false;
  }
  impl_->recordEnvironment(commands, timings);
  impl_->recordClouds(commands, timings);
  impl_->changed = false;
  ++impl_->version;
}

SkyMaps Sky::maps() const noexcept {
  return {impl_->radiance.map(), impl_->environment.image.map(), impl_->light.handle(), impl_->light.size(), {}, {},
          impl_->planetRadius};
}

}  // namespace pelagic
