#include <algorithm>
#include <cmath>
#include <composite/frame.hpp>
#include <composite/fresnel_table.hpp>
#include <glm/gtc/constants.hpp>
#include <pelagic/wave_sampling.hpp>

#include "physics/atmosphere.glsl"
#include "physics/optics.glsl"

namespace pelagic {
namespace {

void setRays(const Camera& camera, VkExtent2D extent, shader::CompositeFrame& frame) noexcept {
  const PixelRays rays = pixelRays(camera, extent);
  // depth w = P22 z + P32 and w = P23 z, so w = P32 / (depth - P22/P23).
  const glm::dmat4 p(camera.projection);
  const double far = camera.reversedDepth ? 0 : 1;
  frame.ray = glm::vec4(glm::dvec4(rays.origin, p[3][2]));
  frame.rayX = glm::vec4(glm::dvec4(rays.right, p[2][2] / p[2][3]));
  frame.rayY = glm::vec4(glm::dvec4(rays.down, far));
  frame.waterAlbedo.w = static_cast<float>(std::sqrt(glm::length(rays.right) * glm::length(rays.down)));
  frame.nearer = camera.reversedDepth ? 1.0f : -1.0f;
}

/// The water's colour. Crests of 0.6 to 3 m let light through.
void setLook(const WaterMedium& medium, shader::CompositeFrame& frame) noexcept {
  const WaterLook& look = medium.look;
  const glm::vec3 deep = look.deep * glm::one_over_pi<float>(), shallow = look.shallow * glm::one_over_pi<float>();
  const glm::vec3 natural = physics::waterLeaving(physics::deepReflectance(medium.absorption, medium.backscatter));
  const bool byAngle = look.law == WaterLook::Law::viewAngle, byThickness = look.law == WaterLook::Law::thickness;
  const glm::vec3 albedo = look.law == WaterLook::Law::medium        ? natural
                           : look.law == WaterLook::Law::deepShallow ? glm::mix(deep, shallow, look.shallowness)
                                                                     : deep;
  frame.waterAlbedo = glm::vec4(albedo, 0);
  frame.lookAlbedo = glm::vec4(shallow, byAngle ? 1 : 0);
  const auto transmittance = [&](float thickness) {
    return byThickness ? glm::vec3(1 - physics::tintOpacity(thickness, look.leastOpacity, look.opaqueDepth))
                       : glm::exp(-thickness * medium.absorption);
  };
  frame.thinCrest = glm::vec4(transmittance(0.6f), 0);
  frame.thickCrest = glm::vec4(transmittance(3.0f), 0);
  frame.skyContrast = look.contrast;
  frame.crestsHide = byThickness ? 1 : 0;
}

/// A vector of the level frame of a place on the planet in that of the eye, which the place is off by `tilt` radii:
/// levelled() of water.comp undone.
glm::dvec3 fromLevel(const glm::dvec3& d, const glm::dvec2& tilt) noexcept {
  const double cosine = std::sqrt(1 - glm::dot(tilt, tilt)), along = d.x * tilt.x + d.z * tilt.y;
  const glm::dvec2 side = glm::dvec2(d.x, d.z) + tilt * (d.y - along / (1 + cosine));
  return {side.x, d.y * cosine - along, side.y};
}

void setLight(const HostLight& light, const glm::dvec3& eye, double planetRadius,
              shader::CompositeFrame& frame) noexcept {
  const bool panel = light.halfWidth != glm::dvec3(0) || light.halfHeight != glm::dvec3(0);
  // What intensity belongs to: the area that a ball or the front of a rectangle shows.
  const double area = panel ? 4 * glm::length(glm::cross(light.halfWidth, light.halfHeight))
                            : glm::pi<double>() * light.radius * light.radius;
  const std::uint32_t i = frame.hostLights++;
  const glm::dvec2 tilt = glm::dvec2(light.position.x - eye.x, light.position.z - eye.z) / planetRadius;
  if (glm::dot(tilt, tilt) >= 1) return;  // beyond what the eye's plane has of the planet: dark
  // The height is over the sea there, which lies below the eye's plane.
  const glm::dvec3 drop(0, glm::dot(tilt, tilt) * planetRadius / (1 + std::sqrt(1 - glm::dot(tilt, tilt))) + eye.y, 0);
  const glm::dvec3 foot = glm::dvec3(tilt.x, 0, tilt.y) * planetRadius - drop;
  const glm::dvec3 place = foot + fromLevel({0, light.position.y, 0}, tilt);
  frame.hostLightPlace[i] = glm::vec4(glm::dvec4(place, panel ? 0 : light.radius));
  frame.hostLightWidth[i] = glm::vec4(glm::dvec4(fromLevel(light.halfWidth, tilt), 0));
  frame.hostLightHeight[i] = glm::vec4(glm::dvec4(fromLevel(light.halfHeight, tilt), 0));
  frame.hostLightRadiance[i] = glm::vec4(glm::dvec4(glm::dvec3(light.intensity) / area, 0));
}

/// Of the slopes' covariance, what maps sampled at footprints of rising powers of two show.
void setResolved(const WaveMaps& waves, shader::CompositeFrame& frame) noexcept {
  const double size = waves.layout.size;
  const double finest = waves.layout.cascades[waves.layout.count - 1].length / size;
  for (std::uint32_t i = 0; i < shader::kFootprints; ++i) {
    glm::dvec3 shown(0);
    for (std::uint32_t c = 0; c < waves.layout.count; ++c) {
      const ResolvedShare& share = waves.resolvedShare[c];
      const double lod = std::max(std::log2(std::exp2(i) * finest * size / waves.layout.cascades[c].length), 0.0);
      const std::size_t mip = static_cast<std::size_t>(lod);
      const auto at = [&](std::size_t index) { return index < share.size() ? share[index] : 0.0; };
      shown += glm::mix(at(mip), at(mip + 1), lod - static_cast<double>(mip)) * waves.slopeCovariance[c];
    }
    frame.resolved[i] = glm::vec4(glm::dvec4(shown, 0));
  }
  frame.sheet.y = static_cast<float>(1 / finest);
}

/// All slopes of the sea, and what it reflects of a ray that comes along it.
void setSlopes(shader::CompositeFrame& frame) noexcept {
  glm::vec4 all = frame.waves.unresolved;
  for (std::uint32_t c = 0; c < frame.waves.cascades; ++c) all += frame.waves.slopeCovariance[c];
  const double deviation = std::sqrt(0.5 * static_cast<double>(all.x + all.y));
  frame.slopes = glm::vec4(glm::vec3(all), static_cast<float>(reflectingFacets(0, deviation).reflectance));
}

}  // namespace

shader::CompositeFrame compositeFrame(const WaveMaps& waves, const WaterBuffer& water, const Camera& camera,
                                      const WaterMedium& medium, VkExtent2D extent,
                                      std::span<const HostLight> lights) noexcept {
  shader::CompositeFrame frame{};
  const glm::dvec2 eye(camera.position.x, camera.position.z);
  frame.waves = waveSampling(waves, eye);
  frame.absorption = glm::vec4(medium.absorption, static_cast<float>(camera.position.y));
  setLook(medium, frame);
  // Old foam begins to be blown into streaks at Beaufort's force 7, 14 m/s; in a gale it is.
  const double streaks = glm::smoothstep(11.0, 18.0, waves.windSpeed);
  frame.thinCrest.w = static_cast<float>(streaks);
  const float height = std::max(static_cast<float>(camera.position.y), 0.0f);
  const float radius = static_cast<float>(water.planetRadius);
  frame.thickCrest.w = shader::horizonElevation(height, radius);
  setRays(camera, extent, frame);
  // In double precision, since the eye may be 1e9 m from the origin.
  const glm::dvec2 wind(std::cos(waves.windDirection), std::sin(waves.windDirection));
  const glm::dvec2 along(glm::dot(eye, wind), glm::dot(eye, glm::dvec2(-wind.y, wind.x)));
  // Twice the period along the wind, where the pattern is drawn out by two.
  const glm::dvec2 period = glm::dvec2(2, 1) * static_cast<double>(shader::kFoamPeriod);
  frame.foam = glm::vec4(glm::dvec4(along - period * glm::floor(along / period), wind));
  const double slickPeriod = static_cast<double>(shader::kSlickPeriod);
  const bool natural = medium.look.law == WaterLook::Law::medium;
  frame.slicks =
      glm::vec4(glm::dvec4(along - slickPeriod * glm::floor(along / slickPeriod), medium.slicks, natural ? 1 : 0));
  for (const HostLight& light : lights) setLight(light, camera.position, water.planetRadius, frame);
  frame.planetRadius = radius;
  setResolved(waves, frame);
  setSlopes(frame);
  frame.sheet.x = water.cellEdge;
  frame.width = extent.width;
  frame.height = extent.height;
  const std::uint32_t tile = shader::kTileSize;
  frame.tiles = ((extent.width + tile - 1) / tile) * ((extent.height + tile - 1) / tile);
  return frame;
}

}  // namespace pelagic
