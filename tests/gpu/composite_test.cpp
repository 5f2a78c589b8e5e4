#include <cmath>
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

/// Water `step` [m] from pixel to pixel.
void spread(SyntheticScene& scene, float step) {
  for (std::size_t i = 0; i < scene.position.size(); ++i) {
    scene.position[i] =
        step * glm::vec2(static_cast<float>(i % scene.extent.width), static_cast<float>(i / scene.extent.width));
  }
}

// White in the mean; near by its hollows are darker and its heads brighter, far off it is even.
TEST_F(CompositeTest, FreshFoamIsAWhiteLambertSurfaceWithARelief) {
  for (const bool near : {true, false}) {
    SyntheticScene scene(gpu(), {128, 128});
    scene.fillWater(near ? 20 : 5000);
    spread(scene, near ? 0.08f : 20);
    scene.foam = 1;
    scene.light.sunIrradiance = glm::vec4(0.7f);
    scene.light.sunRadiance = glm::vec4(1);
    scene.render(device());
    for (std::size_t i = 0; i < 3; ++i) {
      const double white = 0.7 / std::numbers::pi + static_cast<double>(scene.sky[i]);
      double mean = 0, squares = 0;
      for (std::size_t at = i; at < scene.radiance.size(); at += 4) {
        const double shown = static_cast<double>(scene.radiance[at]) / white;
        EXPECT_LT(shown, 1.02) << "no more than came";
        mean += shown / (128 * 128);
        squares += shown * shown / (128 * 128);
      }
      EXPECT_GE(mean, 0.6) << near;
      EXPECT_LE(mean, 0.8) << near;
      const double deviation = std::sqrt(std::max(squares - mean * mean, 0.0)) / mean;
      EXPECT_GT(deviation, near ? 0.15 : 0) << near;
      EXPECT_LT(deviation, near ? 0.35 : 0.02) << near;
    }
    EXPECT_GT(scene.normal[3], 0.9f);
  }
}

// In water that takes red, foam alone is white; between it green and blue come up from the bubbles below, as much as
// the water above those lets through.
TEST_F(CompositeTest, BubblesBelowFoamShowBetweenIt) {
  SyntheticScene scene(gpu(), {16, 16});
  scene.fillWater(5000);
  scene.medium.absorption = glm::vec3(20, 0.2f, 0.05f);
  scene.render(device());
  const glm::dvec3 bare = scene.radianceAt(8, 8);
  scene.foam = 0.3f;
  scene.render(device());
  const glm::dvec3 seen = scene.radianceAt(8, 8);
  const glm::dvec3 sky(scene.sky[0], scene.sky[1], scene.sky[2]), white = 0.78 * sky;
  const double open = (white.x - seen.x) / (white.x - bare.x);
  ASSERT_GT(open, 0.5);
  ASSERT_LT(open, 0.95);
  const glm::dvec3 entering = std::numbers::pi * (1 - 0.0675) * sky;
  const glm::dvec3 plume(physics::plumeLeaving(scene.medium.absorption, scene.foam));
  const glm::dvec3 share = ((seen - (1 - open) * white) / open - bare) / (plume * entering);
  EXPECT_NEAR(share.y / share.z, 1, 0.02);
  EXPECT_GT(share.z, 0.3) << "the surface keeps some of it";
  EXPECT_LT(share.z, 1);
}

TEST_F(CompositeTest, FoamFarOffIsItsMeanCover) {
  SyntheticScene scene(gpu(), {16, 16});
  scene.fillWater(5000);  // a pixel is hundreds of metres wide
  for (const float freshness : {0.1f, 0.3f, 0.8f}) {
    scene.foam = freshness;
    scene.render(device());
    for (std::size_t i = 0; i < scene.normal.size(); i += 4) ASSERT_NEAR(scene.normal[i + 3], freshness, 0.01f);
  }
}

/// Covariance of the foam's cover over its variance, at a lag in pixels.
double correlation(const SyntheticScene& scene, std::uint32_t dx, std::uint32_t dy) {
  const std::uint32_t width = scene.extent.width, height = scene.extent.height;
  const auto cover = [&](std::uint32_t x, std::uint32_t y) {
    return static_cast<double>(scene.normal[4 * (y * width + x) + 3]);
  };
  double mean = 0, variance = 0, product = 0;
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) mean += cover(x, y) / (width * height);
  }
  for (std::uint32_t y = 0; y + dy < height; ++y) {
    for (std::uint32_t x = 0; x + dx < width; ++x) {
      variance += std::pow(cover(x, y) - mean, 2);
      product += (cover(x, y) - mean) * (cover(x + dx, y + dy) - mean);
    }
  }
  return product / variance;
}

TEST_F(CompositeTest, OldFoamIsBlownIntoStreaksByAStrongWind) {
  SyntheticScene scene(gpu(), {160, 160});
  scene.fillWater(100);
  spread(scene, 0.6f);
  scene.foam = 0.3f;
  for (const double direction : {0.0, std::numbers::pi / 2}) {
    scene.waves.windDirection = direction;
    scene.waves.windSpeed = 8;
    scene.render(device());
    const bool alongX = direction == 0;
    const auto along = [&](std::uint32_t lag) { return correlation(scene, alongX ? lag : 0, alongX ? 0 : lag); };
    const auto across = [&](std::uint32_t lag) { return correlation(scene, alongX ? 0 : lag, alongX ? lag : 0); };
    EXPECT_LT(along(12), 0.1) << "lace of metres, no streaks";
    scene.waves.windSpeed = 18;
    scene.render(device());
    EXPECT_GT(along(12), 0.15);
    EXPECT_LT(across(12), 0.5 * along(12));
    double cover = 0;
    for (std::size_t i = 3; i < scene.normal.size(); i += 4)
      cover += static_cast<double>(scene.normal[i]) / (160 * 160);
    EXPECT_NEAR(cover, 0.3, 0.06) << "gathered, not more; 96 m hold few lanes";
  }
}

/// How much of what foam covers it turns white, where the same sea without foam is `bare`.
double opacityOfFoam(const SyntheticScene& scene, const std::vector<float>& bare) {
  double gained = 0, white = 0;
  for (std::size_t i = 0; i < scene.radiance.size(); i += 4) {
    const double water = static_cast<double>(bare[i]);
    gained += static_cast<double>(scene.radiance[i]) - water;
    white += static_cast<double>(scene.normal[i + 3]) * (0.78 * static_cast<double>(scene.sky[0]) - water);
  }
  return gained / white;
}

// Foam of a freshness is as bright in the mean where its lace is seen as where a pixel holds many patches of it, and
// old foam is a film that hides less.
TEST_F(CompositeTest, FoamThinsWithAgeAtEveryDistance) {
  SyntheticScene near(gpu(), {256, 256}), far(gpu(), {16, 16});
  near.fillWater(20);
  far.fillWater(5000);
  spread(near, 0.08f);
  near.render(device());
  far.render(device());
  const std::vector<float> bareNear = near.radiance, bareFar = far.radiance;
  double last = 0.5;
  for (const float freshness : {0.3f, 0.6f, 0.9f}) {
    near.foam = far.foam = freshness;
    near.render(device());
    far.render(device());
    const double seen = opacityOfFoam(far, bareFar);
    EXPECT_NEAR(opacityOfFoam(near, bareNear) / seen, 1, 0.1) << freshness;
    EXPECT_GT(seen, last) << freshness;
    last = seen;
  }
  EXPECT_GT(last, 0.8);
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

TEST_F(CompositeTest, TheSunsDiscCarriesItsIrradiance) {
  SyntheticScene scene(gpu(), {64, 64});
  scene.sky = {0, 0, 0, 1};
  scene.camera.rotation = support::lookAlong(1, -0.3);
  scene.camera.projection = support::perspective(0.02, 1, 0.1, true);
  scene.light.sunDirection = glm::vec4(std::sin(1.0) * std::cos(0.3), std::sin(0.3), -std::cos(1.0) * std::cos(0.3),
                                       std::cos(kSunAngularRadius));
  scene.light.sunRadiance = glm::vec4(1000, 1000, 1000, 1);
  scene.withOutputs = false;
  scene.render(device());
  double sum = 0;
  const double pixel = 2 * std::tan(0.01) / 64;
  for (std::uint32_t y = 0; y < 64; ++y) {
    for (std::uint32_t x = 0; x < 64; ++x) sum += scene.radianceAt(x, y).x * pixel * pixel;
  }
  EXPECT_NEAR(sum / (1000 * std::numbers::pi * kSunAngularRadius * kSunAngularRadius), 1, 0.01);
}

TEST_F(CompositeTest, ErrorsNameTheField) {
  WaterMedium medium;
  medium.absorption.y = -1;
  ASSERT_FALSE(validate(medium));
  EXPECT_NE(validate(medium).error().message.find("WaterMedium::absorption[1] is -1"), std::string::npos);
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
  EXPECT_EQ(view.error().message,
            "SkyMaps::light has 0 bytes, it must have at least " + std::to_string(sizeof(shader::SkyLight)));
}

}  // namespace
