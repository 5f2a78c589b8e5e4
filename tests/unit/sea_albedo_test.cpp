/// What the formulas of shading give back of the light that falls on a sea, against rays traced through one.
#include <gtest/gtest.h>

#include <cmath>
#include <composite/fresnel_table.hpp>
#include <numbers>

#include "physics/fresnel.glsl"
#include "physics/ocean_brdf.glsl"
#include "physics/optics.glsl"
#include "support/reference_tracer.hpp"

namespace {

using namespace pelagic;
using namespace pelagic::physics;
using glm::vec2;
using glm::vec3;
using support::FacetedSea;
using support::SeaLighting;

constexpr double kDegree = std::numbers::pi / 180;

glm::dvec3 direction(double zenith, double azimuth) {
  return {std::sin(zenith * kDegree) * std::cos(azimuth * kDegree), std::cos(zenith * kDegree),
          std::sin(zenith * kDegree) * std::sin(azimuth * kDegree)};
}

/// Slopes of a wind [m/s] after Cox & Munk, along x.
struct Sea {
  std::vector<FacetedSea> seas;
  vec3 covariance{0};
  explicit Sea(double wind) {
    constexpr std::uint32_t kCount = 4;
    for (std::uint32_t seed = 1; seed <= kCount; ++seed) {
      seas.emplace_back(1024, 0.00316 * wind, 0.003 + 0.00192 * wind, seed);
      covariance += vec3(seas.back().slopeCovariance()) / static_cast<float>(kCount);
    }
  }
  /// Mean radiance of what is mirrored.
  double traced(const SeaLighting& light, const glm::dvec3& v) const {
    double sum = 0;
    for (const FacetedSea& sea : seas) {
      const support::SeaRadiance one = traceSea(sea, light, v, v.y > 0.2 ? 10000 : 8000);
      sum += (one.sky.x + one.sun.x) / static_cast<double>(seas.size());
    }
    return sum;
  }
};

/// What a sea over black water sends toward v of an even sky of radiance 1, as sea_light.glsl adds it up.
double skyAlbedo(const vec3& v, const vec3& c) {
  const Visibility seen = visibility(v, vec2(0), c);
  const double sine = std::max(std::hypot(static_cast<double>(v.x), static_cast<double>(v.z)), 1e-3);
  const ReflectingFacets facets =
      reflectingFacets(static_cast<double>(v.y), static_cast<double>(seen.deviation) / sine);
  const SeenSlopes mirrors =
      seenSlopes(seen, v, c, static_cast<float>(facets.facing), static_cast<float>(facets.variance));
  const double again = reflectingFacets(0, std::sqrt(0.5 * static_cast<double>(c.x + c.y))).reflectance;
  const float share = shareOfSky(mirrors.shift, mirrors.covariance, v, glm::vec4(c, again));
  return facets.reflectance * static_cast<double>(share);
}

// The facets' mean reflectance is off by some per cent in rough seas, whose slopes across the view are not those along
// it, and too little at the horizon.
TEST(SeaAlbedo, OfAnEvenSkyIsThatOfTracedRaysAndAtMostOne) {
  SeaLighting even;
  even.sky = [](const glm::dvec3&) { return glm::dvec3(1); };
  struct Limit {
    double wind, tolerance, atHorizon;  // up to 85 degrees from the vertical, and at 89
  };
  for (const Limit& limit : {Limit{2, 0.02, 0.03}, {7, 0.03, 0.07}, {14, 0.04, 0.1}, {20, 0.05, 0.11}}) {
    const Sea sea(limit.wind);
    for (const double azimuth : {0.0, 90.0}) {
      for (const double zenith : {0.0, 40.0, 60.0, 72.0, 80.0, 85.0, 89.0}) {
        const glm::dvec3 v = direction(zenith, azimuth);
        const double albedo = skyAlbedo(vec3(v), sea.covariance);
        const double expected = sea.traced(even, v);
        EXPECT_LE(albedo, 1);
        const double tolerance = zenith > 85 ? limit.atHorizon : limit.tolerance;
        EXPECT_NEAR(albedo / expected, 1, tolerance) << limit.wind << " m/s " << azimuth << ' ' << zenith;
      }
    }
  }
}

// Summed over the hemisphere, what a calm sea sends back is Fresnel's law at n = 1.34 for an even sky; rough seas send
// back less (Cox & Munk 1956), at most a half less.
TEST(SeaAlbedo, OverTheHemisphereIsTheCalmSeasOrLess) {
  const auto hemispherical = [](const vec3& covariance) {
    constexpr int kZenith = 180, kAzimuth = 8;
    double sum = 0;
    for (int i = 0; i < kZenith; ++i) {
      const double zenith = (i + 0.5) * 90 / kZenith, step = 90 * kDegree / kZenith;
      const double weight = 2 * std::sin(zenith * kDegree) * std::cos(zenith * kDegree) * step / kAzimuth;
      for (int j = 0; j < kAzimuth; ++j) {
        sum += weight * skyAlbedo(vec3(direction(zenith, (j + 0.5) * 360 / kAzimuth)), covariance);
      }
    }
    return sum;
  };
  const double calm = hemispherical(vec3(1e-6f, 1e-6f, 0));
  EXPECT_NEAR(calm / static_cast<double>(kDiffuseReflectance), 1, 0.01);
  double last = calm;
  for (const float variance : {1e-3f, 0.01f, 0.04f}) {
    const double rough = hemispherical({variance, 0.6f * variance, 0.1f * variance});
    EXPECT_LT(rough, 1.005 * last) << variance;
    EXPECT_GT(rough, 0.5 * calm) << variance;
    last = rough;
  }
}

TEST(SeaAlbedo, OfALowSunIsThatOfTracedRays) {
  // Toward the sun and nearly, a viewer up to 3 degrees over the horizon, where Smith's law has 1.5 times as much.
  const Sea sea(7);
  SeaLighting light;
  light.sky = [](const glm::dvec3&) { return glm::dvec3(0); };
  light.sunIrradiance = glm::dvec3(1);
  light.sunRadius = 0.05;  // so that rays meet it
  for (const double elevation : {7.0, 20.0, 35.0}) {
    light.sunDirection = direction(90 - elevation, 0);
    for (const double zenith : {75.0, 82.0, 86.0, 87.0}) {
      const glm::dvec3 exact = direction(zenith, 180);
      const vec3 v(exact), l(light.sunDirection);
      const vec2 slope = mirrorSlope(v, l);
      const float incidence = glm::dot(v, glm::normalize(v + l));
      const vec3 disc = discCovariance(slope, l, incidence, static_cast<float>(light.sunRadius));
      const double got = static_cast<double>(sunReflection(visibility(v, vec2(0), sea.covariance),
                                                           visibility(l, vec2(0), sea.covariance), v, slope, vec2(0),
                                                           sea.covariance + disc) *
                                             fresnelReflectance(incidence, kWaterIndex));
      // Within 5 % where the viewer is 4 degrees over the horizon, opposite a low sun.
      const double tolerance = elevation == 7 && zenith == 86 ? 0.05 : 0.15;
      EXPECT_NEAR(got / sea.traced(light, exact), 1, tolerance) << elevation << ' ' << zenith;
    }
  }
}

}  // namespace
