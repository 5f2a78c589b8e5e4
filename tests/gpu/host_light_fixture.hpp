/// Lights of the host over a rough sea without any other light.
#pragma once

#include <cmath>
#include <numbers>

#include "composite_support.hpp"
#include "physics/ocean_brdf.glsl"
#include "physics/optics.glsl"

namespace support {

class HostLightTest : public GpuTest {
 protected:
  /// A rough sea 20 m before the camera and no light at all.
  SyntheticScene darkScene(VkExtent2D extent, double yaw, double pitch) {
    SyntheticScene scene(gpu(), extent);
    scene.camera.position = {2100, 3, -3700};
    scene.camera.rotation = lookAlong(yaw, pitch);
    scene.fillWater(kAxial);
    scene.sky = {0, 0, 0, 1};
    scene.light.skyIrradiance = glm::vec4(0, 0, 0, 1);
    scene.waves.unresolved = {kVariance, kVariance};
    return scene;
  }
  /// World point behind a pixel.
  static glm::dvec3 pointAt(const SyntheticScene& scene, std::uint32_t x, std::uint32_t y) {
    const glm::dvec3 d = scene.directionAt(x, y), forward = -glm::transpose(glm::dmat3(scene.camera.rotation))[2];
    return scene.camera.position + d * (kAxial / glm::dot(d, forward));
  }
  /// What the sea mirrors, seen along it, of the light that `lightAt(scene, toward)` puts `aside` [rad] from straight
  /// ahead.
  template <class LightAt>
  double glintSeenAlong(double aside, const LightAt& lightAt) {
    SyntheticScene scene = darkScene({9, 9}, 0.4, 0.05);
    scene.camera.position.y = 100;
    scene.camera.projection = perspective(0.01, 1, 0.1, true);
    scene.medium.backscatter = glm::vec3(0);
    const glm::dvec3 d = scene.directionAt(4, 4), side(-d.z, 0, d.x);
    const glm::dvec3 toward =
        glm::normalize(std::cos(aside) * glm::dvec3(d.x, 0, d.z) + std::sin(aside) * side + glm::dvec3(0, 0.3, 0));
    scene.lights = {lightAt(scene, toward)};
    scene.render(device());
    return scene.radianceAt(4, 4).g;
  }
  /// Where a light is, as HostLight says it, that stands at `place` from the scene's eye.
  static glm::dvec3 overTheSea(const SyntheticScene& scene, const glm::dvec3& place) {
    const glm::dvec3 eye = scene.camera.position;
    const double fromCentre = glm::length(place + glm::dvec3(0, scene.planetRadius + eye.y, 0));
    const double along = scene.planetRadius / fromCentre;
    return {eye.x + place.x * along, fromCentre - scene.planetRadius, eye.z + place.z * along};
  }
  /// What the sea mirrors toward v of a unit of light from the direction l, which is as narrow as can be.
  static double mirroredFrom(const glm::dvec3& v, const glm::dvec3& l) {
    const glm::vec3 covariance(static_cast<float>(kVariance), static_cast<float>(kVariance), 0), view(v), from(l);
    const auto seen = pelagic::physics::visibility(view, glm::vec2(0), covariance);
    const auto lit = pelagic::physics::visibility(from, glm::vec2(0), covariance);
    const float cosIncidence = glm::dot(view, glm::normalize(view + from));
    return pelagic::physics::fresnelReflectance(cosIncidence, pelagic::physics::kWaterIndex) *
           pelagic::physics::sunReflection(seen, lit, view, pelagic::physics::mirrorSlope(view, from), glm::vec2(0),
                                           covariance);
  }
  /// What leaves the scene's water per irradiance that a light straight above sends on it.
  static double leaving(const SyntheticScene& scene, int channel, double height = 1) {
    const double under = scene.medium.absorption[channel] + scene.medium.backscatter[channel];
    const double r = 0.33 * scene.medium.backscatter[channel] / under;
    const double entering = 1 - pelagic::physics::fresnelReflectance(static_cast<float>(height), 1.34f);
    return entering * 0.96 * r / (1.34 * 1.34 * 4 * (1 - 0.48 * r));
  }
  static constexpr double kPi = std::numbers::pi;
  static constexpr double kAxial = 20, kVariance = 0.02;
};

}  // namespace support
