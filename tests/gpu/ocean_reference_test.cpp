/// The sea of the built-in scenes as it is drawn, against rays traced through the displaced surface of their own waves.
#include <array>
#include <cmath>
#include <cstring>
#include <pelagic/query.hpp>
#include <random>

#include "ocean_scene.hpp"
#include "pelagic/shader/sky_light.h"
#include "physics/atmosphere.glsl"
#include "physics/fresnel.glsl"
#include "physics/ocean_brdf.glsl"
#include "physics/optics.glsl"

namespace {

using namespace pelagic;
using glm::dvec2;
using glm::dvec3;

/// The clear sky and the waves of a scene, for rays.
struct Reference {
  SeaQuery query;
  explicit Reference(const common::Scene& scene)
      : query(SeaQuery::create(common::wavesInfo(scene.sea, MapPrecision::single)).value()) {
    query.setTime(scene.time);
  }
  std::vector<float> sky;  ///< rgba, Sky::maps().radiance
  VkExtent2D skyExtent{};
  shader::SkyLight light{};
  glm::vec3 tail{0};  ///< Covariance of the slopes that the waves lack.
  dvec3 water{0};     ///< Radiance under the surface.
  std::mt19937 random{7};

  dvec3 skyToward(const dvec3& d) const {
    const dvec2 uv(shader::skyUv(glm::vec3(d)));
    const auto column = static_cast<std::uint32_t>(uv.x * skyExtent.width) % skyExtent.width;
    const double row = std::clamp(uv.y * skyExtent.height, 0.5 * skyExtent.height, skyExtent.height - 1.0);
    const float* p = &sky[4 * (static_cast<std::uint32_t>(row) * std::size_t{skyExtent.width} + column)];
    return {p[0], p[1], p[2]};
  }
  /// Slope of a facet about that of the waves: its normal over its height.
  dvec3 facet(const dvec3& normal) {
    std::normal_distribution<double> normals(0, 1);
    const double a = std::sqrt(std::max(static_cast<double>(tail.x), 1e-12)), b = static_cast<double>(tail.z) / a;
    const double x = normals(random), z = normals(random);
    const double c = std::sqrt(std::max(static_cast<double>(tail.y) - b * b, 0.0));
    return dvec3(normal.x / normal.y - a * x, 1, normal.z / normal.y - b * x - c * z);
  }
  /// What a ray that leaves the sea at `from` brings back, at most so many facets later.
  dvec3 along(const dvec3& from, const dvec3& direction, int bounces) {
    const auto hit = query.intersect(from + dvec3(0, 0.01, 0), direction, 60);
    if (!hit && direction.y > 0) return skyToward(direction);
    if (bounces == 0) return dvec3(0);
    const dvec3 at = hit ? hit->position : from, normal = hit ? hit->normal : dvec3(0, 1, 0);
    for (int tries = 0; tries < 50; ++tries) {
      const dvec3 m = facet(normal);
      const double facing = -glm::dot(m, direction);
      if (facing <= 0) continue;
      const dvec3 n = glm::normalize(m);
      const double incidence = std::min(-glm::dot(n, direction), 1.0);
      const double mirrored =
          static_cast<double>(physics::fresnelReflectance(static_cast<float>(incidence), physics::kWaterIndex));
      return mirrored * along(at, direction + 2 * incidence * n, bounces - 1) + (1 - mirrored) * water;
    }
    return dvec3(0);
  }
  /// Radiance toward v of the water at a point that is seen.
  dvec3 radiance(const SurfacePoint& point, const dvec3& v) {
    const glm::vec3 view(v), toSun(light.sunDirection);
    const glm::vec2 slope(dvec2(-point.normal.x, -point.normal.z) / point.normal.y);
    const physics::Visibility seen = physics::visibility(view, slope, tail);
    dvec3 sum(0);
    double weight = 0;
    for (int i = 0; i < 6; ++i) {
      const dvec3 m = facet(point.normal);
      const double facing = glm::dot(m, v);
      if (facing <= 0) continue;
      const double w = facing * static_cast<double>(physics::shareInSight(seen, static_cast<float>(facing)));
      const dvec3 n = glm::normalize(m);
      const double incidence = std::min(glm::dot(n, v), 1.0);
      const double mirrored =
          static_cast<double>(physics::fresnelReflectance(static_cast<float>(incidence), physics::kWaterIndex));
      const dvec3 ray = 2 * incidence * n - v;
      // The facet's own ripples may hide the ray.
      const physics::Visibility out = physics::visibility(glm::vec3(ray), slope, tail);
      const bool open =
          out.mean > 0 && std::uniform_real_distribution<float>(0, 1)(random) <
                              physics::shareInSight(out, static_cast<float>(facing)) * out.mean / out.inSight;
      const dvec3 back = open ? along(point.position, ray, 3) : along(point.position, dvec3(ray.x, -1e-3, ray.z), 3);
      sum += w * (mirrored * back + (1 - mirrored) * water);
      weight += w;
    }
    if (weight > 0) sum /= weight;
    if (!query.intersect(point.position + dvec3(0, 0.01, 0), dvec3(toSun), 60)) {
      const glm::vec2 mirror = physics::mirrorSlope(view, toSun);
      const float incidence = std::max(glm::dot(view, glm::normalize(view + toSun)), 0.0f);
      const glm::vec3 disc = physics::discCovariance(mirror, toSun, incidence, shader::kSunAngularRadius);
      const float glint =
          physics::sunReflection(seen, physics::visibility(toSun, slope, tail), view, mirror, slope, tail + disc);
      sum += dvec3(glm::vec3(light.sunIrradiance)) *
             static_cast<double>(glint * physics::fresnelReflectance(incidence, physics::kWaterIndex));
    }
    return sum;
  }
};

class OceanReferenceTest : public support::GpuTest {};

// Of what has no foam, under the scenes' skies without clouds, without slicks. The sun stands aside, 126 degrees from
// the view: four points of a pixel would miss most of its glint. Waves are those of the maps, down to the finest; the
// facets of what none of them holds are random. Nothing breaks near by a swell later: rays find ripples as they are on
// the average, where those that are drawn are steep on a breaking crest.
TEST_F(OceanReferenceTest, ThirdsOfTheSeaAreAsBrightAsTracedRays) {
  constexpr VkExtent2D kExtent{480, 270};
  constexpr std::uint32_t kStride = 7;
  for (const char* name : {"trade-wind", "overcast-swell"}) {
    support::OceanScene drawnScene(gpu(), device(), name, 12, [](common::Scene& scene) {
      const glm::dvec3 ahead = scene.view.lookAt - scene.view.position;
      scene.sky.sunAzimuth = std::atan2(ahead.z, ahead.x) + 2.2;
      scene.sky.clouds.cover = 0;
      scene.medium.slicks = 0;
      scene.time += 11;
    });
    const common::Scene& scene = drawnScene.scene();
    const std::size_t view = drawnScene.addView(kExtent);
    drawnScene.setTime(scene.time);
    const support::Drawn drawn = drawnScene.draw(view, scene.view);

    Reference reference(scene);
    const SkyMaps sky = drawnScene.ocean().sky().maps();
    reference.sky = common::readFloats(gpu(), sky.radiance);
    reference.skyExtent = sky.radiance.extent;
    const auto bytes = common::readBuffer(gpu(), sky.light, sky.lightSize);
    std::memcpy(&reference.light, bytes.data(), sizeof(reference.light));
    const WaveMaps maps = drawnScene.ocean().waves().maps();
    const glm::vec2 wind(std::cos(maps.windDirection), std::sin(maps.windDirection));
    reference.tail = physics::covarianceOf(static_cast<float>(maps.unresolved.upwind),
                                           static_cast<float>(maps.unresolved.crosswind), wind);
    const glm::vec3 entering =
        physics::enteringIrradiance(glm::vec3(reference.light.sunIrradiance), reference.light.sunDirection.y,
                                    glm::vec3(reference.light.skyIrradiance));
    reference.water = dvec3(
        entering * physics::waterLeaving(physics::deepReflectance(scene.medium.absorption, scene.medium.backscatter)));

    const Camera camera = common::cameraOf(scene.view, static_cast<double>(kExtent.width) / kExtent.height);
    const PixelRays rays = pixelRays(camera, kExtent);
    std::uint32_t first = 0;
    while (drawn.depth[std::size_t{first} * kExtent.width + kExtent.width / 2] == 0) ++first;
    first += 8;
    std::array<dvec3, 3> got{}, expected{};
    std::array<int, 3> count{};
    for (std::uint32_t y = first; y < kExtent.height; y += kStride) {
      const std::size_t third = 3 * (y - first) / (kExtent.height - first);
      for (std::uint32_t x = 0; x < kExtent.width; x += kStride) {
        if (drawn.depth[std::size_t{y} * kExtent.width + x] == 0 ||
            drawn.foam[std::size_t{y} * kExtent.width + x] > 1e-4f)
          continue;
        dvec3 sum(0);
        int hits = 0;
        for (int i = 0; i < 4; ++i) {
          const dvec2 at(x + 0.25 + 0.5 * (i % 2) - 0.5, y + 0.25 + 0.5 * (i / 2) - 0.5);
          const dvec3 d = glm::normalize(rays.origin + at.x * rays.right + at.y * rays.down);
          const auto point = reference.query.intersect(camera.position, d, 600);
          if (!point) continue;
          sum += reference.radiance(*point, -d);
          ++hits;
        }
        if (hits < 4) continue;
        expected[third] += sum / 4.0;
        got[third] += drawn.at(x, y);
        ++count[third];
      }
    }
    for (std::size_t third = 0; third < 3; ++third) {
      ASSERT_GT(count[third], 300) << name;
      for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(got[third][channel] / expected[third][channel], 1, 0.1) << name << ' ' << third;
      }
    }
  }
}

}  // namespace
