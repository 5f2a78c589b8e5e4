/// What the sky of sea level and the views of it share.
#pragma once

#include <sky/clouds.hpp>
#include <sky/environment.hpp>
#include <sky/host_picture.hpp>

namespace pelagic {

namespace sky {

/// Resting state of the light: readable by any shader, as a storage or uniform buffer.
inline constexpr gpu::BufferState kLightRead{
    vk::PipelineStageFlagBits2::eVertexShader | vk::PipelineStageFlagBits2::eFragmentShader |
        vk::PipelineStageFlagBits2::eComputeShader,
    vk::AccessFlagBits2::eShaderStorageRead | vk::AccessFlagBits2::eUniformRead};

/// How far the sun is below the horizon when the moon takes over as the light that casts shadows and glitters [rad]:
/// then either is lost in the twilight.
inline constexpr double kMoonTakesOver = 0.035;
bool moonCastsShadows(const SkyState& state) noexcept;
/// Irradiance of the moon over the air, 0 below the horizon [the sun's].
double moonlight(const SkyState& state) noexcept;
glm::vec3 toward(double elevation, double azimuth) noexcept;
/// The sky that the moon lights: `step` is a pass of clear.comp that writes `image`, which then rests in kShaderRead.
void recordMoonlit(const gpu::Context& context, vk::CommandBuffer commands, Step& step, gpu::Image& image,
                   const shader::SkyPass& push, std::uint32_t rows) noexcept;

/// `airRows`: 0, or shader::kAirRows for the maps of an eye at `altitude` [m].
shader::SkyPass passOf(const SkyState& state, double planetRadius, double altitude, std::uint32_t airRows) noexcept;
/// A buffer for a SkyLight block.
Result<gpu::Buffer> createLight(gpu::Context& context, std::string_view name);

}  // namespace sky

struct Sky::Impl {
  gpu::Context* context = nullptr;
  SkyState state;
  double planetRadius = kEarthRadius;  ///< At sea level [m].
  double time = 0;                     ///< Of the last record [s].
  bool airChanged = true;              ///< What depends on the haze alone must be computed again.
  bool changed = true;
  bool cloudsChanged = true;  ///< Their shape.
  sky::HostSky hostSky;       ///< Shown instead, where it has a width.
  bool hostChanged = true;
  std::uint64_t version = 0;  ///< Counts the states that were recorded.
  /// What was recorded last: views follow it, whatever has been set since.
  struct Recorded {
    SkyState state;
    bool hosted = false;
    double rotation = 0;  ///< Of the host's picture [rad].
  } recorded;
  gpu::Image transmittance, clear, moonlit, radiance;
  gpu::Buffer scattering, light;
  gpu::Unique<vk::Sampler> clamped, turning, repeat, repeatEverywhere;
  sky::Step transmittanceStep, scatteringStep, clearStep, moonStep, lightStep, radianceStep;
  sky::Environment environment;
  sky::Clouds clouds;
  sky::HostPicture hostPicture;
  sky::Step hostStep;

  bool hosted() const noexcept { return hostSky.width > 0; }
  double cloudCover() const noexcept { return recorded.hosted ? 0 : recorded.state.clouds.cover; }
  bool cloudy() const noexcept { return cloudCover() > 0; }
  Result<void> createResources();
  Result<void> createSteps();
  void recordAir(vk::CommandBuffer commands, const shader::SkyPass& push, Timings* timings) noexcept;
  void recordRadiance(vk::CommandBuffer commands, const shader::SkyPass& push, Timings* timings) noexcept;
  void recordHost(vk::CommandBuffer commands, Timings* timings) noexcept;
  void recordEnvironment(vk::CommandBuffer commands, Timings* timings) noexcept;
  void recordClouds(vk::CommandBuffer commands, Timings* timings) noexcept;
};

}  // namespace pelagic
