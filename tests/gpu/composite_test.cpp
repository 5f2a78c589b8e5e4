#include <cmath>
#include <limits>
#include <numbers>
#include <pelagic/wave_sampling.hpp>

#include "composite_support.hpp"
#include "physics/optics.glsl"

namespace {

using namespace pelagic;
using support::SyntheticScene;

class CompositeTest : public support::GpuTest {};

/// What leaves the water under the scene's sky and a sun of irradiance `sun` at the zenith.
glm::dvec3 waterRadiance(const SyntheticScene& scene, double sun) {
  const double flat = std::pow((1.34 - 1) / (1.34 + 1), 2);
  glm::dvec3 result;
  for (int i = 0; i < 3; ++i) {
    const double r = 0.33 * scene.medium.backscatter[i] / (scene.medium.absorption[i] + scene.medium.backscatter[i]);
    const double entering = sun * (1 - flat) + std::numbers::pi * scene.sky[static_cast<std::size_t>(i)] * (1 - 0.0675);
    result[i] = 0.96 * r * entering / (1.34 * 1.34 * 4 * (1 - 0.48 * r));
  }
  return result;
}

double fresnel(double cosine) {
  const double g = std::sqrt(1.34 * 1.34 - 1 + cosine * cosine);
  const double s = std::pow((cosine - g) / (cosine + g), 2);
  return 0.5 * s * (1 + std::pow((cosine * (cosine + g) - 1) / (cosine * (g - cosine) + 1), 2));
}

TEST_F(CompositeTest, FlatSeaReflectsFresnelsShare) {
  SyntheticScene scene(gpu(), {61, 45});
  scene.fillWater(20);
  scene.render(device());
  const glm::dvec3 under = waterRadiance(scene, 0);
  for (std::uint32_t y = 2; y < 45; y += 6) {
    for (std::uint32_t x = 1; x < 61; x += 9) {
      const double share = fresnel(-scene.directionAt(x, y).y);
      for (int i = 0; i < 3; ++i) {
        const double expected = share * scene.sky[static_cast<std::size_t>(i)] + (1 - share) * under[i];
        EXPECT_NEAR(scene.radianceAt(x, y)[i] / expected, 1, 0.01) << x << ' ' << y;
      }
    }
  }
}

/// The warp's shift at p, as waveWarp() in shader/wave_lookup.glsl.
glm::dvec2 warpAt(const shader::WaveWarp& warp, const glm::dvec2& p) {
  glm::dvec2 shift(0);
  for (int i = 0; i < 8; ++i) {
    const auto of = [&](const glm::vec4(&values)[2]) { return static_cast<double>(values[i / 4][i % 4]); };
    double t = of(warp.phase) + of(warp.alongX) * p.x + of(warp.alongZ) * p.y;
    t -= std::round(t);
    shift += 8 * t * (1 - 2 * std::abs(t)) * glm::dvec2(of(warp.shiftX), of(warp.shiftZ));
  }
  return shift;
}

TEST_F(CompositeTest, SlopesFollowTheWarp) {
  SyntheticScene scene(gpu(), {16, 16});
  scene.camera.rotation = support::lookAlong(0, 0.9);
  scene.camera.position = {2100, scene.camera.position.y, -3700};
  scene.fillWater(20);
  const glm::dvec2 p(150, -400);
  for (glm::vec2& position : scene.position) position = glm::vec2(p);
  scene.waves.warp = 0.1;
  scene.gradient = {0.1f, -0.3f, 0.06f, -0.04f};
  scene.moments[3] = 0.05f;
  scene.render(device());
  // The surface over p is (x + Dx, h, z + Dz) of q = p + w(p), with constant derivatives over q.
  const glm::dmat2x3 overQ(0.06, 0.1, 0.05, 0.05, -0.3, -0.04);
  const shader::WaveWarp warp = waveSampling(scene.waves, {2100, -3700}).warp;
  constexpr double kStep = 0.5;
  const auto along = [&](const glm::dvec2& axis) {
    const glm::dvec2 q = axis + (warpAt(warp, p + kStep * axis) - warpAt(warp, p - kStep * axis)) / (2 * kStep);
    EXPECT_GT(glm::length(q - axis), 0.03);
    return glm::dvec3(axis.x, 0, axis.y) + overQ * q;
  };
  const glm::dvec3 n = glm::normalize(glm::cross(along({0, 1}), along({1, 0})));
  EXPECT_NEAR(scene.normal[0], n.x, 1e-3);
  EXPECT_NEAR(scene.normal[1], n.y, 1e-3);
  EXPECT_NEAR(scene.normal[2], n.z, 1e-3);
}

TEST_F(CompositeTest, TiltedSeaTurnsTheReflection) {
  SyntheticScene scene(gpu(), {16, 16});
  scene.camera.rotation = support::lookAlong(0, 0.9);  // toward -z
  scene.fillWater(20);
  scene.gradient = {0.1f, -0.3f, 0, 0};
  scene.render(device());
  const glm::dvec3 n = glm::normalize(glm::dvec3(-0.1, 1, 0.3));
  EXPECT_NEAR(scene.normal[0], n.x, 1e-3);
  EXPECT_NEAR(scene.normal[1], n.y, 1e-3);
  EXPECT_NEAR(scene.normal[2], n.z, 1e-3);
  const double share = fresnel(-glm::dot(scene.directionAt(8, 8), n));
  const double expected = share * scene.sky[0] + (1 - share) * waterRadiance(scene, 0).x;
  EXPECT_NEAR(scene.radianceAt(8, 8).x / expected, 1, 0.01);
}

TEST_F(CompositeTest, CompressedWaterIsSteeper) {
  SyntheticScene scene(gpu(), {8, 8});
  scene.fillWater(20);
  scene.gradient = {0.1f, 0.05f, -0.5f, 0};  // dh/dx, dh/dz, dDx/dx, dDz/dz
  scene.render(device());
  const glm::dvec3 n = glm::normalize(glm::dvec3(-0.1 / 0.5, 1, -0.05));
  EXPECT_NEAR(scene.normal[0], n.x, 2e-3);
  EXPECT_NEAR(scene.normal[2], n.z, 2e-3);
}

TEST_F(CompositeTest, RoughSeaReflectsTheSunsLight) {
  // Straight down on isotropic slopes with the sun at the zenith: F E p(0) / 4, p(0) = 1/(2 pi sigma^2).
  SyntheticScene scene(gpu(), {9, 9});
  scene.camera.rotation = support::lookAlong(0, std::numbers::pi / 2);
  scene.camera.projection = support::perspective(0.01, 1, 0.1, true);
  scene.fillWater(20);
  scene.sky = {0, 0, 0, 1};
  scene.light.skyIrradiance = glm::vec4(0);
  scene.light.sunIrradiance = glm::vec4(0.7f);
  scene.light.sunRadiance = glm::vec4(1e4f);
  scene.waves.unresolved = {0.02, 0.02};
  scene.render(device());
  const double share = std::pow(0.34 / 2.34, 2);
  const double glint = share * 0.7 / (4 * 2 * std::numbers::pi * 0.02);
  const double under = (1 - share) * waterRadiance(scene, 0.7).x;
  EXPECT_NEAR(scene.radianceAt(4, 4).x / (glint + under), 1, 0.03);
}

TEST_F(CompositeTest, ResidualVarianceIsTheMapsPlusTheUnresolved) {
  SyntheticScene scene(gpu(), {8, 8});
  scene.fillWater(20);
  scene.moments = {0.011f, 0.013f, 0.002f, 0};
  scene.waves.windDirection = std::numbers::pi / 2;  // toward +z
  scene.waves.unresolved = {0.02, 0.03};
  scene.render(device());
  EXPECT_NEAR(scene.slopeVariance[0], 0.011 + 0.03, 1e-4);
  EXPECT_NEAR(scene.slopeVariance[1], 0.013 + 0.02, 1e-4);
}

TEST_F(CompositeTest, WhatThePixelCannotResolveCountsAsItsExpectedVariance) {
  SyntheticScene scene(gpu(), {8, 8});
  scene.waves.layout.cascades[0].length = 0.5;
  scene.waves.slopeCovariance[0] = {0.04, 0.05, 0};
  scene.gradient = {0.2f, 0.2f, 0, 0};
  scene.fillWater(5000);  // a pixel is hundreds of metres wide
  scene.render(device());
  EXPECT_NEAR(scene.slopeVariance[0], 0.04, 1e-4);
  EXPECT_NEAR(scene.slopeVariance[1], 0.05, 1e-4);
  EXPECT_NEAR(scene.normal[1], 1, 1e-5);
}

TEST_F(CompositeTest, FarWaterFadesIntoTheHorizon) {
  SyntheticScene scene(gpu(), {8, 8});
  scene.fillWater(20000);
  scene.camera.position.y = 3;
  scene.light.rayleighExtinction = glm::vec4(1e-5f, 2e-5f, 4e-5f, 8000);
  scene.light.mieExtinction = glm::vec4(glm::vec3(3e-5f), 1200);
  scene.render(device());
  SyntheticScene clear(gpu(), {8, 8});
  clear.fillWater(20000);
  clear.render(device());
  const double away = 20000 / glm::dot(scene.directionAt(4, 4), glm::dvec3(0, -std::sin(0.5), -std::cos(0.5)));
  for (int i = 0; i < 3; ++i) {
    const double t = std::exp(-away * (scene.light.rayleighExtinction[i] + 3e-5));
    const double expected = t * clear.radianceAt(4, 4)[i] + (1 - t) * scene.sky[static_cast<std::size_t>(i)];
    EXPECT_NEAR(scene.radianceAt(4, 4)[i] / expected, 1, 0.01);
  }
}

TEST_F(CompositeTest, EveryPixelIsWrittenOnceWhateverTheTile) {
  // Odd extents, a diagonal shore through the tiles; the images start as NaN.
  SyntheticScene scene(gpu(), {75, 43});
  for (std::uint32_t y = 0; y < 43; ++y) {
    for (std::uint32_t x = 0; x < 75; ++x) {
      const std::size_t i = y * 75 + x;
      scene.body[i] = x + y > 60 ? 1 : 0;
      scene.depth[i] = scene.body[i] ? scene.depthAt(20) : 0;
    }
  }
  scene.render(device());
  for (const auto* values : {&scene.radiance, &scene.normal, &scene.slopeVariance, &scene.mergedDepth}) {
    for (const float value : *values) ASSERT_TRUE(std::isfinite(value));
  }
  for (std::uint32_t y = 0; y < 43; ++y) {
    for (std::uint32_t x = 0; x < 75; ++x) {
      const std::size_t i = y * 75 + x;
      ASSERT_EQ(scene.mergedDepth[i], scene.depth[i]);
      ASSERT_NEAR(glm::length(glm::vec3(scene.normal[4 * i], scene.normal[4 * i + 1], scene.normal[4 * i + 2])),
                  scene.body[i], 1e-3);
      if (x + y == 60 || x + y == 61) continue;  // smoothed
      ASSERT_EQ(std::abs(scene.radianceAt(x, y).x - scene.sky[0]) < 1e-3f, scene.body[i] == 0);
    }
  }
}

/// Columns of four pixels: host nearer than water, host behind water, host before the sky, nothing over sky.
void hostScene(SyntheticScene& scene) {
  const float far = scene.camera.reversedDepth ? 0.0f : 1.0f;
  for (std::uint32_t i = 0; i < scene.depth.size(); ++i) {
    const std::uint32_t column = i % 16 / 4;
    scene.body[i] = column < 2 ? 1 : 0;
    scene.depth[i] = column < 2 ? scene.depthAt(20) : far;
    scene.hostDepth[i] = column == 0   ? scene.depthAt(10)
                         : column == 1 ? scene.depthAt(30)
                         : column == 2 ? scene.depthAt(50)
                                       : far;
  }
  scene.withHost = true;
}

TEST_F(CompositeTest, HostAndWaterHideEachOther) {
  for (const bool reversed : {true, false}) {
    SyntheticScene plain(gpu(), {16, 16});
    plain.camera.reversedDepth = reversed;
    plain.camera.projection = support::perspective(0.8, 1, 0.1, reversed);
    hostScene(plain);
    plain.withHost = false;
    plain.render(device());
    SyntheticScene scene(gpu(), {16, 16});
    scene.camera = plain.camera;
    hostScene(scene);
    scene.render(device());
    EXPECT_EQ(scene.radianceAt(1, 5), glm::vec3(7, 8, 9));
    EXPECT_EQ(scene.radianceAt(5, 5), plain.radianceAt(5, 5));
    EXPECT_LT(scene.radianceAt(5, 5).x, 1);
    EXPECT_EQ(scene.radianceAt(9, 5), glm::vec3(7, 8, 9));
    EXPECT_EQ(scene.radianceAt(13, 5), plain.radianceAt(13, 5));
    EXPECT_EQ(scene.mergedDepth[5 * 16 + 1], scene.depthAt(10));
    EXPECT_EQ(scene.mergedDepth[5 * 16 + 5], scene.depthAt(20));
    EXPECT_EQ(scene.mergedDepth[5 * 16 + 9], scene.depthAt(50));
    EXPECT_EQ(scene.mergedDepth[5 * 16 + 13], reversed ? 0.0f : 1.0f);
    EXPECT_EQ(scene.normal[4 * (5 * 16 + 1) + 1], 0);
  }
}

// However the lens spreads its rim: 15 pixels of radius, 4, 1 and a third, of which the sum over pixels knows
// less.
TEST_F(CompositeTest, TheSunsDiscCarriesItsIrradiance) {
  for (const float fov : {0.02f, 0.08f, 0.3f, 0.9f}) {
    SyntheticScene scene(gpu(), {64, 64});
    scene.sky = {0, 0, 0, 1};
    scene.camera.rotation = support::lookAlong(1, -0.3);
    scene.camera.projection = support::perspective(fov, 1, 0.1, true);
    scene.light.sunDirection = glm::vec4(std::sin(1.0) * std::cos(0.3), std::sin(0.3), -std::cos(1.0) * std::cos(0.3),
                                         std::cos(kSunAngularRadius));
    scene.light.sunRadiance = glm::vec4(1000, 1000, 1000, 1);
    scene.withOutputs = false;
    scene.render(device());
    double sum = 0;
    const double pixel = 2 * std::tan(0.5 * static_cast<double>(fov)) / 64;
    for (std::uint32_t y = 0; y < 64; ++y) {
      for (std::uint32_t x = 0; x < 64; ++x) sum += static_cast<double>(scene.radianceAt(x, y).x) * pixel * pixel;
    }
    EXPECT_NEAR(sum / (1000 * std::numbers::pi * kSunAngularRadius * kSunAngularRadius), 1, fov < 0.5f ? 0.01 : 0.03)
        << fov;
  }
}

TEST_F(CompositeTest, ErrorsNameTheField) {
  WaterMedium medium;
  medium.absorption.y = -1;
  ASSERT_FALSE(validate(medium));
  EXPECT_NE(validate(medium).error().message.find("WaterMedium::absorption[1] is -1"), std::string::npos);
  medium = {};
  medium.slicks = std::numeric_limits<double>::quiet_NaN();
  ASSERT_FALSE(validate(medium));
  EXPECT_NE(validate(medium).error().message.find("WaterMedium::slicks is nan"), std::string::npos);
  medium = {};
  medium.look.contrast = 0.5f;
  ASSERT_FALSE(validate(medium));
  EXPECT_EQ(validate(medium).error().message, "WaterLook::contrast is 0.5, it must be 1 to 4");
  medium = {};
  medium.look.law = static_cast<WaterLook::Law>(7);
  ASSERT_FALSE(validate(medium));
  EXPECT_EQ(validate(medium).error().message, "WaterLook::law is 7, it must be 0 to 3");
  ToneMapInfo info;
  const auto toneMap = ToneMap::create(device(), info);
  ASSERT_FALSE(toneMap);
  EXPECT_EQ(toneMap.error().message, "ToneMapInfo::input is null");
}

TEST_F(CompositeTest, ASkyWithoutItsLightIsRefused) {
  const auto output =
      common::createImage(gpu(), vk::Format::eR16G16B16A16Sfloat, {16, 16}, vk::ImageUsageFlagBits::eStorage, "output");
  CompositeTargets targets;
  targets.output = output.host(common::kUndefined, common::kTransferSource);
  WaterBuffer water;
  water.depth.extent = {16, 16};
  auto composite = Composite::create(device());
  ASSERT_TRUE(composite) << composite.error().message;
  const auto view = CompositeView::create(*composite, {}, {}, water, targets);
  ASSERT_FALSE(view);
  std::string expected = "SkyMaps::light has 0 bytes, it must have at least ";
  expected += std::to_string(sizeof(shader::SkyLight));
  EXPECT_EQ(view.error().message, expected);
}

}  // namespace
