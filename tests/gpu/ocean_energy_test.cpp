/// The light of the far sea is the same however many pixels share it, and however coarse the sheet is that carries it.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "ocean_scene.hpp"

namespace {

using support::Drawn;
using support::OceanScene;
using Edit = std::function<void(common::Scene&)>;

class OceanEnergyTest : public support::GpuTest {
 protected:
  /// Of a scene, on a sheet with cells of `edge` [px], summed over the moments.
  glm::dvec3 onSheetOf(float edge, const char* name, const pelagic::GainMap& gain = {}, const Edit& edit = {});
};

/// The far third of the water, in parts of the picture's height: 45 m off to where the horizon begins to show in a
/// pixel.
constexpr double kFirst = support::kHorizonFromAbove + 0.013, kLast = 0.645;

glm::dvec3 farRadiance(const Drawn& drawn) {
  const auto row = [&](double part) { return static_cast<std::uint32_t>(std::lround(part * drawn.extent.height)); };
  glm::dvec3 sum(0);
  for (std::uint32_t y = row(kFirst); y < row(kLast); ++y) {
    for (std::uint32_t x = 0; x < drawn.extent.width; ++x) sum += drawn.at(x, y);
  }
  return sum / static_cast<double>((row(kLast) - row(kFirst)) * drawn.extent.width);
}

// The scenes, but the one from 10 km.
constexpr const char* kScenes[] = {"trade-wind", "fresh-overcast", "gale",      "storm",  "overcast-swell",
                                   "calm-dawn",  "sunset-glitter", "noon-calm", "moonlit"};
constexpr VkExtent2D kSmallest{160, 90};
// Of three moments a storm or a low sun is 4 % off: a coarse picture of crests and of glitter has few pixels.
constexpr int kMoments = 12;
constexpr double kApart = 7;  // [s]

glm::dvec3 OceanEnergyTest::onSheetOf(float edge, const char* name, const pelagic::GainMap& gain, const Edit& edit) {
  OceanScene scene(gpu(), device(), name, edge, edit, gain);
  const std::size_t view = scene.addView({2 * kSmallest.width, 2 * kSmallest.height});
  glm::dvec3 sum(0);
  for (int moment = 0; moment < kMoments; ++moment) {
    scene.setTime(scene.scene().time + kApart * moment);
    sum += farRadiance(scene.draw(view, support::fromAbove(scene.scene())));
  }
  return sum;
}

void expectEqual(const glm::dvec3& a, const glm::dvec3& b, const std::string& what) {
  for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(a[channel] / b[channel], 1, 0.02) << what << ' ' << channel;
}

// Pixels four times as small resolve waves of which the larger ones only know how many stand in each other's way.
TEST_F(OceanEnergyTest, IsTheSameAtOnceTwiceAndFourTimesTheResolution) {
  for (const char* name : kScenes) {
    OceanScene scene(gpu(), device(), name);
    glm::dvec3 means[3] = {};
    for (std::uint32_t i = 0; i < 3; ++i) scene.addView({kSmallest.width << i, kSmallest.height << i});
    for (int moment = 0; moment < kMoments; ++moment) {
      scene.setTime(scene.scene().time + kApart * moment);
      for (std::size_t i = 0; i < 3; ++i) means[i] += farRadiance(scene.draw(i, support::fromAbove(scene.scene())));
    }
    expectEqual(means[1], means[0], std::string(name) + " 2x");
    expectEqual(means[2], means[0], std::string(name) + " 4x");
    expectEqual(means[2], means[1], std::string(name) + " 4x to 2x");
  }
}

// The same pixels of the same sea, whichever way the picture's columns run.
TEST_F(OceanEnergyTest, IsTheSameWithTheCameraOnItsSide) {
  constexpr std::uint32_t kSide = 2 * kSmallest.height;
  for (const char* name : kScenes) {
    OceanScene scene(gpu(), device(), name);
    const std::size_t view = scene.addView({kSide, kSide});
    scene.setTime(scene.scene().time);
    const Drawn upright = scene.draw(view, support::fromAbove(scene.scene()));
    Drawn turned = scene.draw(view, support::fromAbove(scene.scene()), std::numbers::pi / 2);
    const Drawn onItsSide = turned;
    for (std::uint32_t y = 0; y < kSide; ++y) {
      for (std::uint32_t x = 0; x < kSide; ++x) {
        const std::size_t from = 4 * (x * std::size_t{kSide} + kSide - 1 - y);
        std::copy_n(&onItsSide.radiance[from], 4, &turned.radiance[4 * (y * std::size_t{kSide} + x)]);
      }
    }
    expectEqual(farRadiance(turned), farRadiance(upright), name);
  }
}

// What the sheet is too coarse to hide is hidden in shading.
TEST_F(OceanEnergyTest, IsTheSameOnAnySheet) {
  for (const char* name : kScenes) expectEqual(onSheetOf(24, name), onSheetOf(3, name), name);
}

// As much of it as the waves are higher there.
TEST_F(OceanEnergyTest, IsTheSameOnAnySheetWhereGainsVary) {
  pelagic::GainMap gusts;
  gusts.origin = {-4000, -4000};
  gusts.spacing = 150;
  gusts.width = gusts.height = 54;
  gusts.bands = 1;
  for (std::uint32_t i = 0; i < gusts.width * gusts.height; ++i) {
    gusts.gains.push_back((i / gusts.width + i % gusts.width) % 2 == 0 ? 1.9f : 0.9f);
  }
  // A sea without foam, which lies behind crests that a coarse sheet does not show: gusts of 8 m/s are 3 % brighter
  // there. Its swell is high and the sun aside, so that without the gain in the hiding it would be 3.2 %.
  const auto high = [](common::Scene& scene) {
    scene.sea.state.swell = {{6, 12, glm::radians(177.0), 200}};
    scene.sky.sunAzimuth = glm::radians(100.0);
  };
  expectEqual(onSheetOf(24, "overcast-swell", gusts, high), onSheetOf(3, "overcast-swell", gusts, high), "gusts");
}

}  // namespace
