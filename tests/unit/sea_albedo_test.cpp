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
      seas.push_back(one(wind, seed));
      covariance += vec3(seas.back().slopeCovariance()) / static_cast<float>(kCount);
    }
  }
  /// Its longest waves, with the part `longest` of the slopes' variance.
  static FacetedSea one(double wind, std::uint32_t seed, double longest = 1) {
    return {1024, 0.00316 * wind, 0.003 + 0.00192 * wind, seed, longest};
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

/// What a place over black water sends toward v of an even sky of radiance 1, as sea_light.glsl adds it up: a place
/// with the slope `mean` and the covariance c about it, of a sea whose slopes have the covariance `all`.
double skyAlbedo(const vec3& v, const vec2& mean, const vec3& c, const vec3& all) {
  const Visibility seen = visibility(v, mean, c);
  const double sine = std::max(std::hypot(static_cast<double>(v.x), static_cast<double>(v.z)), 1e-3);
  const vec3 normal = glm::normalize(vec3(-mean.x, 1, -mean.y));
  const ReflectingFacets facets =
      reflectingFacets(std::max(static_cast<double>(glm::dot(v, normal)), 0.0),
                       static_cast<double>(seen.deviation) / sine * static_cast<double>(normal.y));
  const SeenSlopes mirrors =
      seenSlopes(seen, v, c, static_cast<float>(facets.facing), static_cast<float>(facets.variance));
  const double again = reflectingFacets(0, std::sqrt(0.5 * static_cast<double>(all.x + all.y))).reflectance;
  const float share = shareOfSky(mean + mirrors.shift, mirrors.covariance, v, glm::vec4(all, again));
  return facets.reflectance * static_cast<double>(share);
}
/// Of a sea no wave of which is resolved.
double skyAlbedo(const vec3& v, const vec3& c) { return skyAlbedo(v, vec2(0), c, c); }

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

// Where pixels know how the longer waves lie: a half or four fifths of the slopes' variance. Their backs, which rise
// toward the viewer, are as bright as traced rays have them, and so are their faces.
TEST(SeaAlbedo, OfBacksAndFacesOfWavesIsThatOfTracedRays) {
  constexpr std::uint32_t kSeas = 2, kRays = 12000;
  SeaLighting even;
  even.sky = [](const glm::dvec3&) { return glm::dvec3(1); };
  for (const double wind : {7.0, 14.0}) {
    const Sea sea(wind);
    for (const double part : {0.5, 0.8}) {
      std::vector<FacetedSea> longer;
      vec3 known(0), all(0);
      for (std::uint32_t seed = 1; seed <= kSeas; ++seed) {
        longer.push_back(Sea::one(wind, seed, part));
        known += vec3(longer.back().slopeCovariance()) / static_cast<float>(kSeas);
        all += vec3(sea.seas[seed - 1].slopeCovariance()) / static_cast<float>(kSeas);
      }
      for (const double zenith : {60.0, 72.0, 80.0}) {
        const glm::dvec3 v = direction(zenith, 0);
        struct Class {
          double got = 0, expected = 0;
          int count = 0;
        } classes[4];  // backs, flat, faces, steep faces
        for (std::uint32_t k = 0; k < kSeas; ++k) {
          for (std::uint32_t i = 0; i < kRays; ++i) {
            const FacetedSea::Hit hit = facetSeen(sea.seas[k], v, i);
            const glm::dvec2 slope = longer[k].slope(hit.position.x, hit.position.z);
            const double rise = -slope.x / std::sqrt(static_cast<double>(known.x));  // away from the viewer
            Class& c = classes[static_cast<std::size_t>(std::clamp(std::floor(rise + 1.5), 0.0, 3.0))];
            c.got += skyAlbedo(vec3(v), vec2(slope), all - known, all);
            c.expected += traceRay(sea.seas[k], even, hit.position + 1e-3 * v, -v).sky.x;
            ++c.count;
          }
        }
        for (const Class& c : classes) {
          ASSERT_GT(c.count, 700);
          EXPECT_NEAR(c.got / c.expected, 1, 0.06) << wind << " m/s " << part << ' ' << zenith << ' ' << &c - classes;
        }
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
