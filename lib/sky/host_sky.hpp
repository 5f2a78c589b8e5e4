/// A host's picture of the sky taken apart into what the sky stage works with.
#pragma once

#include <pelagic/shader/sky_light.h>

#include <glm/gtc/type_precision.hpp>
#include <pelagic/sky.hpp>

namespace pelagic::sky {

struct HostSky {
  std::uint32_t width = 0;           ///< 0: there is none.
  std::uint32_t rows = 0;            ///< From the zenith to the horizon.
  std::vector<glm::u16vec4> texels;  ///< Radiance without the sun, as halves.
  double rotation = 0;               ///< [rad]
  glm::vec3 skyIrradiance{0};        ///< Of `texels`, on the horizontal.
  EnvironmentSun sun;
};

/// `environment` must be valid.
HostSky hostSky(const SkyEnvironment& environment);
/// The block that tells of it, in the air of `state`.
shader::SkyLight hostLight(const HostSky& sky, const SkyState& state) noexcept;

}  // namespace pelagic::sky
