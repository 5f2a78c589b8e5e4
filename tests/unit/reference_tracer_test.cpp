/// The reference that the light of the sea is compared with.
#include "support/reference_tracer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace {

using support::FacetedSea;
using support::SeaLighting;
using support::SeaRadiance;
constexpr double kPi = std::numbers::pi;

glm::dvec3 direction(double zenith, double azimuth) {
  return {std::sin(zenith) * std::cos(azimuth), std::cos(zenith), std::sin(zenith) * std::sin(azimuth)};
}

double reflectance(double c) {
  const double g = std::sqrt(1.34 * 1.34 - 1 + c * c);
  return 0.5 * std::pow((c - g) / (c + g), 2) * (1 + std::pow((c * (g + c) - 1) / (c * (g - c) + 1), 2));
}

TEST(ReferenceTracer, SeaHasTheSlopesAskedFor) {
  const FacetedSea sea(512, 0.03, 0.015, 3);
  const glm::dvec3 c = sea.slopeCovariance();
  EXPECT_NEAR(c.x, 0.03, 0.003);
  EXPECT_NEAR(c.y, 0.015, 0.002);
  EXPECT_NEAR(c.z, 0, 0.002);
}

TEST(ReferenceTracer, RaysMeetTheFirstFacet) {
  const FacetedSea sea(128, 0.04, 0.04, 1);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 d = -direction(unit(random) * 1.5, 2 * kPi * unit(random));
    const glm::dvec3 start(128 * unit(random), sea.top() + 0.1, 128 * unit(random));
    FacetedSea::Hit hit;
    ASSERT_TRUE(sea.intersect(start, d, hit));
    // Where the ray goes straight down from any earlier point, the surface is lower.
    const double reach = glm::dot(hit.position - start, d);
    for (int step = 0; step <= 50; ++step) {
      const glm::dvec3 p = start + d * (reach * step / 50);
      FacetedSea::Hit below;
      ASSERT_TRUE(sea.intersect({p.x, sea.top(), p.z}, {0, -1, 0}, below));
      EXPECT_LE(below.position.y, p.y + 1e-6) << step;
      if (step == 50) {
        EXPECT_NEAR(below.position.y, p.y, 1e-6);
      }
    }
    EXPECT_LT(glm::dot(hit.normal, d), 0);
  }
}

TEST(ReferenceTracer, NoLightIsLostOrMade) {
  const FacetedSea sea(256, 0.03, 0.03, 2);
  SeaLighting even;
  even.sky = [](const glm::dvec3&) { return glm::dvec3(1); };
  even.waterRadiance = glm::dvec3(1);
  for (const double zenith : {0.0, 50.0, 80.0, 87.0}) {
    EXPECT_NEAR(traceSea(sea, even, direction(zenith * kPi / 180, 1), 20000).sum().x, 1, 1e-4) << zenith;
  }
}

TEST(ReferenceTracer, CalmSeaIsAMirror) {
  const FacetedSea sea(256, 1e-8, 1e-8, 2);
  SeaLighting light;
  light.sky = [](const glm::dvec3& d) { return glm::dvec3(d.y, d.x, 0); };
  light.waterRadiance = glm::dvec3(0.3);
  light.sunRadius = 0.01;
  light.sunIrradiance = glm::dvec3(0.8);
  const glm::dvec3 v = direction(1.2, 0);
  light.sunDirection = direction(1.2, kPi);
  const SeaRadiance got = traceSea(sea, light, v, 1000);
  const double mirrored = reflectance(v.y);
  EXPECT_NEAR(got.sky.x, mirrored * v.y, 1e-4);
  EXPECT_NEAR(got.sky.y, -mirrored * v.x, 1e-4);
  EXPECT_NEAR(got.water.x, (1 - mirrored) * 0.3, 1e-4);
  EXPECT_NEAR(got.sun.x / (mirrored * 0.8 / (kPi * 0.01 * 0.01)), 1, 1e-3);
  light.sunDirection = direction(1.2, kPi - 0.02);
  EXPECT_EQ(traceSea(sea, light, v, 1000).sun.x, 0);
}

}  // namespace
