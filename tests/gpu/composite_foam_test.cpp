#include <cmath>
#include <numbers>

#include "composite_support.hpp"
#include "physics/optics.glsl"

namespace {

using namespace pelagic;
using support::SyntheticScene;

class CompositeFoamTest : public support::GpuTest {};

constexpr double kFoamAlbedo = 0.8;  ///< Of foam that hides the water, as in composite/foam.glsl.

// White in the mean; near by its hollows are darker and its heads brighter, far off it is even.
TEST_F(CompositeFoamTest, FreshFoamIsAWhiteLambertSurfaceWithARelief) {
  for (const bool near : {true, false}) {
    SyntheticScene scene(gpu(), {128, 128});
    scene.fillWater(near ? 20 : 5000);
    scene.spread(near ? 0.08f : 20);
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
      EXPECT_GE(deviation, near ? 0.15 : 0) << near;
      EXPECT_LT(deviation, near ? 0.35 : 0.02) << near;
    }
    EXPECT_GT(scene.normal[3], 0.9f);
  }
}

/// Fresh foam from near, in the light of a sun from `toward`. Its pixels lie 0.04 m apart,
/// `slant` times as far away from the eye.
class LitFoam {
 public:
  static constexpr std::uint32_t kSide = 96;

  LitFoam(const common::GpuDevice& gpu, Device& device, float slant) : device_(&device), scene_(gpu, {kSide, kSide}) {
    scene_.fillWater(20);
    scene_.spread(0.04f);
    for (glm::vec2& p : scene_.position) p.y *= slant;
    scene_.foam = 1;
    scene_.light.skyIrradiance = glm::vec4(0);
    scene_.light.sunRadiance = glm::vec4(1);
  }
  const std::vector<float>& from(glm::vec3 toward, float irradiance = 1) {
    scene_.light.sunIrradiance = glm::vec4(irradiance);
    scene_.light.sunDirection = glm::vec4(glm::normalize(toward), scene_.light.sunDirection.w);
    scene_.render(*device_);
    return scene_.radiance;
  }
  double meanFrom(glm::vec3 toward, float irradiance = 1) {
    double sum = 0;
    const std::vector<float>& lit = from(toward, irradiance);
    for (std::size_t i = 0; i < lit.size(); i += 4) sum += static_cast<double>(lit[i]);
    return sum / (kSide * kSide);
  }

 private:
  Device* device_;
  SyntheticScene scene_;
};

// Lit from opposite sides, foam differs by the slope of its relief, whose heads are the brighter ones under a light
// straight above: the sides that face the light are bright, to the left and right as well as near and far.
TEST_F(CompositeFoamTest, ReliefFacesTheLight) {
  constexpr std::size_t kSide = LitFoam::kSide;
  for (const float slant : {1.0f, 4.0f}) {
    LitFoam foam(gpu(), device(), slant);
    const std::vector<float> above = foam.from({0, 1, 0});
    for (const bool aside : {true, false}) {
      const glm::vec3 toward = aside ? glm::vec3(1, 1, 0) : glm::vec3(0, 1, 1);  // pixels' x and y run along +x and +z
      const std::vector<float> lit = foam.from(toward), unlit = foam.from(toward * glm::vec3(-1, 1, -1));
      double product = 0, squares = 0, falls = 0, sum = 0;
      for (std::size_t y = 1; y + 1 < kSide; ++y) {
        for (std::size_t x = 1; x + 1 < kSide; ++x) {
          const std::size_t at = y * kSide + x, step = aside ? 1 : kSide;
          const auto fall = static_cast<double>(above[4 * (at - step)] - above[4 * (at + step)]);
          const auto gained = static_cast<double>(lit[4 * at] - unlit[4 * at]);
          product += fall * gained;
          squares += gained * gained;
          falls += fall * fall;
          sum += static_cast<double>(lit[4 * at] + unlit[4 * at]);
        }
      }
      const double pixels = (kSide - 2) * (kSide - 2), contrast = std::sqrt(squares / pixels) / (0.5 * sum / pixels);
      EXPECT_GT(product / std::sqrt(squares * falls), 0.4) << slant << ' ' << aside;
      EXPECT_GT(contrast, 0.15) << slant << ' ' << aside;
      EXPECT_LT(contrast, 0.7) << slant << ' ' << aside;
    }
  }
}

// What a slope of the relief takes from one side it gives to the other, however low the sun.
TEST_F(CompositeFoamTest, ReliefKeepsTheLight) {
  LitFoam foam(gpu(), device(), 1);
  const double unlit = foam.meanFrom({0, 1, 0}, 0), above = foam.meanFrom({0, 1, 0}) - unlit;
  for (const float degrees : {3.0f, 20.0f, 60.0f}) {
    const float elevation = glm::radians(degrees);
    const double lit = foam.meanFrom({std::cos(elevation), std::sin(elevation), 0}) - unlit;
    EXPECT_NEAR(lit / (above * static_cast<double>(std::sin(elevation))), 1, 0.03) << degrees;
  }
}

// In water that takes red, foam alone is white; between it green and blue come up from the bubbles below, as much as
// the water above those lets through.
TEST_F(CompositeFoamTest, BubblesBelowFoamShowBetweenIt) {
  SyntheticScene scene(gpu(), {16, 16});
  scene.fillWater(5000);
  scene.medium.absorption = glm::vec3(20, 0.2f, 0.05f);
  scene.render(device());
  const glm::dvec3 bare = scene.radianceAt(8, 8);
  scene.foam = 0.3f;
  scene.render(device());
  const glm::dvec3 seen = scene.radianceAt(8, 8);
  const glm::dvec3 sky(scene.sky[0], scene.sky[1], scene.sky[2]), white = kFoamAlbedo * sky;
  const double open = (white.x - seen.x) / (white.x - bare.x);
  ASSERT_GT(open, 0.5);
  ASSERT_LT(open, 0.95);
  const glm::dvec3 entering = std::numbers::pi * (1 - 0.0675) * sky;
  const glm::dvec3 plume(physics::plumeLeaving(scene.medium.absorption, scene.foam));
  const glm::dvec3 share = ((seen - (1 - open) * white) / open - bare) / (plume * entering);
  EXPECT_NEAR(share.y / share.z, 1, 0.02);
  EXPECT_GT(share.z, 0.3) << "the surface keeps some of it";
  EXPECT_LT(share.z, 1);

  // An artist's look has a colour of its own, whatever the water takes.
  scene.medium.look.law = WaterLook::Law::deepShallow;
  scene.render(device());
  const glm::dvec3 painted = scene.radianceAt(8, 8);
  scene.medium.absorption = glm::vec3(1);
  scene.render(device());
  EXPECT_EQ(glm::dvec3(scene.radianceAt(8, 8)), painted);
}

TEST_F(CompositeFoamTest, FoamFarOffIsItsMeanCover) {
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

TEST_F(CompositeFoamTest, OldFoamIsBlownIntoStreaksByAStrongWind) {
  SyntheticScene scene(gpu(), {160, 160});
  scene.fillWater(100);
  scene.spread(0.6f);
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
    white += static_cast<double>(scene.normal[i + 3]) * (kFoamAlbedo * static_cast<double>(scene.sky[0]) - water);
  }
  return gained / white;
}

// Foam of a freshness is as bright in the mean where its lace is seen as where a pixel holds many patches of it, and
// old foam is a film that hides less.
TEST_F(CompositeFoamTest, FoamThinsWithAgeAtEveryDistance) {
  SyntheticScene near(gpu(), {256, 256}), far(gpu(), {16, 16});
  near.fillWater(20);
  far.fillWater(5000);
  near.spread(0.08f);
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

}  // namespace
