#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "pelagic/shader/constants.h"
#include "physics/fresnel.glsl"
#include "physics/ocean_brdf.glsl"

namespace {

using namespace pelagic;
using glm::vec2;
using glm::vec3;
constexpr double kPi = std::numbers::pi;

vec3 direction(double zenith, double azimuth) {
  return {std::sin(zenith) * std::cos(azimuth), std::cos(zenith), std::sin(zenith) * std::sin(azimuth)};
}
double degrees(double d) { return d * kPi / 180; }

/// Calls f(slope, weight), the weights of the Gaussian of covariance c about 0 summing to 1.
template <class F>
void overSlopes(const vec3& c, F f) {
  // Cholesky factor of the covariance.
  const double a = std::sqrt(c.x);
  const double b = c.z / a;
  const double d = std::sqrt(c.y - b * b);
  constexpr int kSteps = 400;
  const double h = 14.0 / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const double x = -7 + (i + 0.5) * h;
      const double y = -7 + (j + 0.5) * h;
      f(vec2(a * x, b * x + d * y), h * h * std::exp(-0.5 * (x * x + y * y)) / (2 * kPi));
    }
  }
}

struct Case {
  vec3 covariance;
  vec2 mean;
};
const std::vector<Case> kCases = {
    {{1e-4f, 1e-4f, 0}, {0, 0}},
    {{0.02f, 0.03f, 0}, {0, 0}},
    {{0.03f, 0.01f, 0.008f}, {0.1f, 0}},
    {{0.005f, 0.02f, -0.006f}, {-0.3f, 0.2f}},
    {{0.09f, 0.16f, 0.05f}, {0.05f, 0.1f}},
};

TEST(OceanBrdf, DensityIntegratesToOne) {
  for (const Case& c : kCases) {
    // On a grid that does not know the covariance.
    const double reach = 7 * std::sqrt(std::max(c.covariance.x, c.covariance.y));
    constexpr int kSteps = 700;
    const double h = 2 * reach / kSteps;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      for (int j = 0; j < kSteps; ++j) {
        sum += h * h * physics::slopeDensity(vec2(-reach + (i + 0.5) * h, -reach + (j + 0.5) * h), c.covariance);
      }
    }
    EXPECT_NEAR(sum, 1, 1e-3);
  }
}

TEST(OceanBrdf, WhatSmithsLawShowsIntegratesToOne) {
  // The papers' q^e = p max(v.f, 0) / ((1 + Lambda) f.y cos), its denominator being the area, from the zenith to 88
  // degrees.
  for (const auto& [along, across] : {std::pair{0.01, 0.01}, {0.05, 0.1}, {0.2, 0.15}, {0.4, 0.4}}) {
    const vec3 c(along * along, across * across, 0);
    constexpr int kSteps = 600;
    const double dx = 14 * along / kSteps, dz = 14 * across / kSteps;
    for (const double zenith : {0.0, 30.0, 60.0, 80.0, 88.0}) {
      const vec3 v = direction(degrees(zenith), 0.4);
      const double area = physics::visibility(v, vec2(0), c).area;
      double sum = 0;
      for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
          const vec2 s(-7 * along + (i + 0.5) * dx, -7 * across + (j + 0.5) * dz);
          const vec3 f = glm::normalize(vec3(-s.x, 1, -s.y));
          sum += dx * dz * physics::slopeDensity(s, c) * std::max(glm::dot(v, f), 0.0f) / (f.y * area);
        }
      }
      EXPECT_NEAR(sum, 1, 2e-3) << along << ' ' << zenith;
    }
  }
}

TEST(OceanBrdf, AreaAgreesWithQuadrature) {
  for (const Case& c : kCases) {
    for (const double zenith : {0.0, 40.0, 75.0, 88.0, 90.0}) {
      const vec3 v = direction(degrees(zenith), 0.7);
      double area = 0;
      overSlopes(c.covariance, [&](const vec2& s, double w) {
        area += w * std::max(v.y - glm::dot(vec2(v.x, v.z), c.mean + s), 0.0f);
      });
      EXPECT_NEAR(physics::visibility(v, c.mean, c.covariance).area / area, 1, 2e-3) << zenith;
    }
  }
}

TEST(OceanBrdf, SlopesSeenAgreeWithQuadrature) {
  for (const Case& c : kCases) {
    for (const double zenith : {0.0, 40.0, 75.0, 88.0, 90.0}) {
      const vec3 v = direction(degrees(zenith), 0.7);
      const vec2 vh(v.x, v.z);
      const vec2 g(c.covariance.x * vh.x + c.covariance.z * vh.y, c.covariance.z * vh.x + c.covariance.y * vh.y);
      const double tau = std::sqrt(std::max(glm::dot(g, vh), 1e-10f));
      // A mean facet turned away is moved to the edge of what is seen.
      const double facing = v.y - glm::dot(vh, c.mean);
      const vec2 moved = g * static_cast<float>(std::min(facing, 0.0) / (tau * tau));
      const double z = std::max(facing, 0.0) / tau;
      double weight = 0;
      glm::dvec2 first{0};
      glm::dvec3 second{0};
      overSlopes(c.covariance, [&](const vec2& s, double w) {
        const double x = (v.y - glm::dot(vh, c.mean + moved + s)) / tau;
        if (x <= 0) return;
        w *= x * (1 - std::exp(-2 * (x + 0.2) * (z + 0.2)));
        const glm::dvec2 from(moved + s);
        weight += w;
        first += w * from;
        second += w * glm::dvec3(from.x * from.x, from.y * from.y, from.x * from.y);
      });
      first /= weight;
      second = second / weight - glm::dvec3(first.x * first.x, first.y * first.y, first.x * first.y);
      const auto visible = physics::visibility(v, c.mean, c.covariance);
      const auto sight = physics::sightOfFacet(visible);
      const auto seen =
          physics::seenSlopes(visible, v, c.covariance, sight.mean - static_cast<float>(z), sight.variance);
      const double scale = std::sqrt(std::max(c.covariance.x, c.covariance.y));
      EXPECT_NEAR(seen.shift.x, first.x, 3e-3 * scale) << zenith;
      EXPECT_NEAR(seen.shift.y, first.y, 3e-3 * scale) << zenith;
      EXPECT_NEAR(seen.covariance.x, second.x, 5e-3 * scale * scale) << zenith;
      EXPECT_NEAR(seen.covariance.y, second.y, 5e-3 * scale * scale) << zenith;
      EXPECT_NEAR(seen.covariance.z, second.z, 5e-3 * scale * scale) << zenith;
    }
  }
}

TEST(OceanBrdf, WavesOfAVisibleFacetAreMovedIntoSight) {
  // Mean and variance of X of slopes drawn about a facet's, moved; against quadrature of what is in sight of them.
  const vec3 c{0.02f, 0.01f, 0.004f};
  const vec3 v = direction(degrees(80), 0.7);
  const vec2 vh(v.x, v.z);
  const double tau = std::sqrt(static_cast<double>(physics::covarianceAlong(c, vh)));
  const vec2 along = physics::covarianceTimes(c, vh) / static_cast<float>(tau * tau);
  for (const double z : {0.05, 0.5, 1.5, 4.0, 20.0}) {
    // A slope whose facet is seen with the area z tau.
    const vec2 facet = vh * static_cast<float>((v.y - z * tau) / glm::dot(vh, vh));
    double mean = 0, square = 0, weight = 0, first = 0, second = 0;
    overSlopes(c, [&](const vec2& s, double w) {
      const vec2 m = physics::facingSlope(facet + s, v, static_cast<float>(z * tau), c);
      const double seen = (v.y - glm::dot(vh, m)) / tau;
      mean += w * seen;
      square += w * seen * seen;
      // Only moved along the direction that the view goes with.
      const vec2 moved = m - facet - s;
      EXPECT_NEAR(moved.x * along.y, moved.y * along.x, 1e-4);
      const double x = (v.y - glm::dot(vh, facet + s)) / tau;
      if (x <= 0) return;
      w *= x * (1 - std::exp(-2 * (x + 0.2) * (z + 0.2)));
      weight += w;
      first += w * x;
      second += w * x * x;
    });
    first /= weight;
    second = second / weight - first * first;
    EXPECT_NEAR(mean, first, 0.01) << z;
    EXPECT_NEAR(square - mean * mean, second, 0.01) << z;
  }
}

TEST(OceanBrdf, AreaIsThePapersCosineAndLambda) {
  const vec3 c{0.02f, 0.03f, 0};
  for (const double zenith : {5.0, 45.0, 70.0, 85.0, 89.0}) {
    for (const double azimuth : {0.0, 0.5, kPi / 2}) {
      const vec3 v = direction(degrees(zenith), azimuth);
      const double variance = c.x * std::pow(std::cos(azimuth), 2) + c.y * std::pow(std::sin(azimuth), 2);
      const double tan2 = std::pow(std::tan(degrees(zenith)), 2);
      const double a = 1 / std::sqrt(2 * variance * tan2);
      const double lambda = (std::exp(-a * a) - a * std::sqrt(kPi) * std::erfc(a)) / (2 * a * std::sqrt(kPi));
      const auto seen = physics::visibility(v, vec2(0), c);
      EXPECT_NEAR(seen.area, std::cos(degrees(zenith)) * (1 + lambda), 1e-6);
      EXPECT_NEAR(physics::smithLambda(seen), lambda, 2e-5 * (1 + lambda));
    }
  }
}

TEST(OceanBrdf, LambdaLimits) {
  const vec3 c{0.02f, 0.02f, 0};
  EXPECT_NEAR(physics::smithLambda(physics::visibility(direction(0, 0), vec2(0), c)), 0, 1e-6);
  // Toward the horizon Lambda nears 1/(2 a sqrt(pi)) - 1/2.
  const double zenith = degrees(89.95);
  const double a = 1 / (std::sqrt(2 * 0.02) * std::tan(zenith));
  const double lambda = physics::smithLambda(physics::visibility(direction(zenith, 1), vec2(0), c));
  EXPECT_NEAR(lambda / (1 / (2 * a * std::sqrt(kPi)) - 0.5), 1, 2e-3);
}

TEST(OceanBrdf, AreaOfFacesTurnedAwayStaysPositiveAndExact) {
  const vec3 c{0.01f, 0.01f, 0};
  const vec3 v{1, 0, 0};
  double last = 1;
  for (double z = 2; z > -6; z -= 0.25) {  // mu / tau
    const auto seen = physics::visibility(v, vec2(-z * 0.1, 0), c);
    // Integral of the normal distribution's upper tail.
    const double exact =
        0.1 * (std::exp(-0.5 * z * z) / std::sqrt(2 * kPi) + z * 0.5 * std::erfc(-z / std::numbers::sqrt2));
    EXPECT_GT(seen.area, 0);
    EXPECT_LT(seen.area, last);
    const double tolerance = z > -3 ? 1e-3 : 0.035;
    EXPECT_NEAR(seen.area / exact, 1, tolerance) << z;
    last = seen.area;
  }
}

TEST(OceanBrdf, TailAgreesWithErfc) {
  for (double z = 0; z < 8; z += 0.05) {
    const double exact = 0.5 * std::erfc(z / std::numbers::sqrt2);
    EXPECT_NEAR(physics::scaledTail(static_cast<float>(z)) * std::exp(-0.5 * z * z), exact, 2e-7) << z;
  }
}

TEST(OceanBrdf, FurnaceNeverReturnsMoreThanItGot) {
  // An even sky of radiance 1 and a perfect mirror: what comes back is 1 less the light that bounces twice.
  for (const float variance : {0.0025f, 0.01f, 0.04f}) {
    for (const double zenith : {10.0, 50.0, 80.0, 88.0}) {
      const vec3 c{variance, variance, 0};
      const vec3 v = direction(degrees(zenith), 0);
      const auto seen = physics::visibility(v, vec2(0), c);
      double sum = 0;
      overSlopes(c, [&](const vec2& s, double w) {
        const vec3 h = glm::normalize(vec3(-s.x, 1, -s.y));
        const float vh = glm::dot(v, h);
        const vec3 l = 2 * vh * h - v;
        if (vh <= 0 || l.y <= 0) return;
        const auto lit = physics::visibility(l, vec2(0), c);
        // d omega_l = 4 h.y^3 (v.h) d^2 s; the density is already in the weight.
        const double measure = 4 * std::pow(h.y, 3) * vh;
        sum += w * measure * physics::sunReflection(seen, lit, v, s, vec2(0), c) / physics::slopeDensity(s, c);
      });
      EXPECT_LE(sum, 1.002) << variance << ' ' << zenith;
      EXPECT_GE(sum, zenith < 60 ? 0.95 : 0.4) << variance << ' ' << zenith;
    }
  }
}

TEST(OceanBrdf, AlbedoOfTheSunsLightIsAtMostOne) {
  // Flux that leaves over flux that comes, from a sun at any height: of perfect mirrors, and of water.
  for (const float variance : {0.0025f, 0.01f, 0.04f}) {
    const vec3 c{variance, 0.7f * variance, 0};
    for (const double zenith : {5.0, 40.0, 70.0, 85.0}) {
      const vec3 l = direction(degrees(zenith), 0.5);
      const auto lit = physics::visibility(l, vec2(0), c);
      double mirror = 0, water = 0;
      overSlopes(c, [&](const vec2& s, double w) {
        const vec3 h = glm::normalize(vec3(-s.x, 1, -s.y));
        const float lh = glm::dot(l, h);
        const vec3 v = 2 * lh * h - l;
        if (lh <= 0 || v.y <= 0) return;
        const auto seen = physics::visibility(v, vec2(0), c);
        // d omega_v = 4 h.y^3 (l.h) d^2 s; the density is already in the weight.
        const double flux = w * 4 * std::pow(h.y, 3) * lh * v.y / l.y *
                            physics::sunReflection(seen, lit, v, s, vec2(0), c) / physics::slopeDensity(s, c);
        mirror += flux;
        water += flux * physics::fresnelReflectance(lh, physics::kWaterIndex);
      });
      EXPECT_LE(mirror, 1.002) << variance << ' ' << zenith;
      EXPECT_GE(mirror, zenith < 60 ? 0.95 : 0.4) << variance << ' ' << zenith;
      // A rough sea mirrors a high sun like a flat one, and a low sun less.
      const double flat = physics::fresnelReflectance(l.y, physics::kWaterIndex);
      EXPECT_LE(water, 1.2 * flat) << variance << ' ' << zenith;
      if (zenith < 60) {
        EXPECT_GE(water, 0.95 * flat) << variance << ' ' << zenith;
      }
    }
  }
}

TEST(OceanBrdf, IsReciprocal) {
  // Radiance per irradiance of the mean facet; exact while the mean facet faces both.
  const vec3 c{0.02f, 0.01f, 0.004f};
  for (const vec2 mean : {vec2(0), vec2(0.1f, -0.05f)}) {
    for (const double first : {0.0, 35.0, 60.0, 80.0}) {
      for (const double second : {10.0, 50.0, 75.0}) {
        const vec3 v = direction(degrees(first), 0.3);
        const vec3 l = direction(degrees(second), 3.0);
        const auto a = physics::visibility(v, mean, c);
        const auto b = physics::visibility(l, mean, c);
        ASSERT_GT(std::min(a.mean, b.mean), 0);
        const vec2 slope = physics::mirrorSlope(v, l);
        const double forward = physics::sunReflection(a, b, v, slope, mean, c) / b.mean;
        const double backward = physics::sunReflection(b, a, l, slope, mean, c) / a.mean;
        EXPECT_NEAR(forward, backward, 2e-5 * forward + 1e-12) << first << ' ' << second;
      }
    }
  }
}

/// The Gaussian that stands for the sun's disc has tails, which steep facets seen along the sea would mirror far beside
/// it.
TEST(OceanBrdf, ASettingSunIsMirroredBelowItselfAlone) {
  const vec3 c{0.01f, 0.01f, 0}, l = direction(degrees(89.7), kPi), v0 = direction(degrees(89.8), 0);
  const auto glint = [&](const vec3& v) {
    const vec2 slope = physics::mirrorSlope(v, l);
    const vec3 disc =
        physics::discCovariance(slope, l, glm::dot(v, glm::normalize(v + l)), pelagic::shader::kSunAngularRadius);
    return physics::sunReflection(physics::visibility(v, vec2(0), c), physics::visibility(l, vec2(0), c), v, slope,
                                  vec2(0), c + disc);
  };
  for (const double azimuth : {2.0, 3.0, 5.0, 8.0}) {
    EXPECT_LT(glint(direction(degrees(89.8), degrees(azimuth))), 1e-3f * glint(v0)) << azimuth;
  }
}

TEST(OceanBrdf, MirrorSlopeReflects) {
  const vec3 v = direction(degrees(70), 1);
  const vec3 l = direction(degrees(50), 3.6);
  const vec2 s = physics::mirrorSlope(v, l);
  const vec3 n = glm::normalize(vec3(-s.x, 1, -s.y));
  const vec3 r = 2 * glm::dot(n, v) * n - v;
  EXPECT_LT(glm::distance(r, l), 1e-6f);
}

/// Mean of a point light's reflection over the sun's disc.
double overDisc(const vec3& v, const vec3& l, const vec2& mean, const vec3& c, double radius) {
  const vec3 e1 = glm::normalize(glm::cross(l, vec3(0.3f, 0.2f, 0.9f)));
  const vec3 e2 = glm::cross(l, e1);
  const auto seen = physics::visibility(v, mean, c);
  double sum = 0;
  constexpr int kRings = 60;
  constexpr int kSpokes = 120;
  for (int i = 0; i < kRings; ++i) {
    const double r = radius * std::sqrt((i + 0.5) / kRings);
    for (int j = 0; j < kSpokes; ++j) {
      const double t = 2 * kPi * j / kSpokes;
      const vec3 p =
          glm::normalize(l + static_cast<float>(r * std::cos(t)) * e1 + static_cast<float>(r * std::sin(t)) * e2);
      sum += physics::sunReflection(seen, physics::visibility(p, mean, c), v, physics::mirrorSlope(v, p), mean, c);
    }
  }
  return sum / (kRings * kSpokes);
}

TEST(OceanBrdf, DiscWideningAgreesWithQuadratureOverTheDisc) {
  constexpr double kRadius = 0.004675;
  for (const float deviation : {0.003f, 0.01f, 0.05f}) {
    for (const double sun : {30.0, 75.0}) {
      for (const double off : {0.0, 1.0}) {  // distance of the mirroring slope from the mean, in deviations
        const vec3 v = direction(degrees(65), 0.4);
        const vec3 l = direction(degrees(sun), 0.4 + kPi + 0.2);
        const vec2 slope = physics::mirrorSlope(v, l);
        const vec2 mean = slope + static_cast<float>(off) * deviation * vec2(0.6f, 0.8f);
        const vec3 c{deviation * deviation, deviation * deviation, 0};
        const vec3 h = glm::normalize(v + l);
        const vec3 wide = c + physics::discCovariance(slope, l, glm::dot(v, h), static_cast<float>(kRadius));
        const double got = physics::sunReflection(physics::visibility(v, mean, c), physics::visibility(l, mean, c), v,
                                                  slope, mean, wide);
        // Slopes finer than the disc's own show that it is no Gaussian.
        const double tolerance = deviation < 0.005f ? 0.1 : 0.02;
        EXPECT_NEAR(got / overDisc(v, l, mean, c, kRadius), 1, tolerance) << deviation << ' ' << sun << ' ' << off;
      }
    }
  }
}

TEST(OceanBrdf, DiscWideningHasTheDiscsSecondMoments) {
  // Directly: the covariance of the mirroring slopes over the disc.
  constexpr double kRadius = 0.004675;
  const vec3 v = direction(degrees(70), 0.4);
  const vec3 l = direction(degrees(60), 2.5);
  const vec3 e1 = glm::normalize(glm::cross(l, vec3(0.3f, 0.2f, 0.9f)));
  const vec3 e2 = glm::cross(l, e1);
  const vec2 centre = physics::mirrorSlope(v, l);
  glm::dvec3 sum{0};
  constexpr int kCount = 4000;
  for (int i = 0; i < kCount; ++i) {
    const double r = kRadius * std::sqrt((i + 0.5) / kCount);
    const double t = 2.399963 * i;
    const vec3 p =
        glm::normalize(l + static_cast<float>(r * std::cos(t)) * e1 + static_cast<float>(r * std::sin(t)) * e2);
    const glm::dvec2 d = physics::mirrorSlope(v, p) - centre;
    sum += glm::dvec3(d.x * d.x, d.y * d.y, d.x * d.y) / static_cast<double>(kCount);
  }
  const vec3 wide = physics::discCovariance(centre, l, glm::dot(v, glm::normalize(v + l)), static_cast<float>(kRadius));
  EXPECT_NEAR(wide.x / sum.x, 1, 0.01);
  EXPECT_NEAR(wide.y / sum.y, 1, 0.01);
  EXPECT_NEAR(wide.z / sum.z, 1, 0.01);
}

TEST(OceanBrdf, MirroredPlaceAndItsDerivativesAreThoseOfTheMirroredRay) {
  const auto place = [](const glm::dvec2& s, const glm::dvec3& v) {
    const glm::dvec3 n = glm::normalize(glm::dvec3(-s.x, 1, -s.y));
    const glm::dvec3 r = 2 * glm::dot(n, v) * n - v;
    return glm::dvec2(r.x, r.z) / (1 + r.y);
  };
  for (const glm::dvec3 view : {glm::dvec3(0, 1, 0), glm::dvec3(0.6, 0.1, -0.3), glm::dvec3(-0.2, 0.5, 0.9)}) {
    const glm::dvec3 v = glm::normalize(view);
    for (const glm::dvec2 s : {glm::dvec2(0, 0), glm::dvec2(0.3, -0.1), glm::dvec2(-0.15, 0.4)}) {
      const auto mirrored = physics::mirroredBy(glm::vec2(s), glm::vec3(v));
      const glm::dvec2 expected = place(s, v);
      EXPECT_NEAR(mirrored.place.x, expected.x, 1e-5);
      EXPECT_NEAR(mirrored.place.y, expected.y, 1e-5);
      constexpr double kStep = 1e-5;
      const glm::dvec2 x = (place(s + glm::dvec2(kStep, 0), v) - place(s - glm::dvec2(kStep, 0), v)) / (2 * kStep);
      const glm::dvec2 z = (place(s + glm::dvec2(0, kStep), v) - place(s - glm::dvec2(0, kStep), v)) / (2 * kStep);
      EXPECT_NEAR(mirrored.alongX.x, x.x, 1e-4);
      EXPECT_NEAR(mirrored.alongX.y, x.y, 1e-4);
      EXPECT_NEAR(mirrored.alongZ.x, z.x, 1e-4);
      EXPECT_NEAR(mirrored.alongZ.y, z.y, 1e-4);
    }
  }
}

}  // namespace
