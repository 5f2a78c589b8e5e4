/// The light of the far sea is the same however many pixels share it, and however coarse the sheet is that carries it.
#include <cmath>

#include "ocean_scene.hpp"

namespace {

using support::Drawn;
using support::OceanScene;

class OceanEnergyTest : public support::GpuTest {};

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

constexpr const char* kLights[] = {"trade-wind", "sunset-glitter", "overcast-swell"};  // high sun, low sun, clouds
constexpr VkExtent2D kSmallest{160, 90};

void expectEqual(const glm::dvec3& a, const glm::dvec3& b, const std::string& what) {
  for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(a[channel] / b[channel], 1, 0.02) << what << ' ' << channel;
}

// Pixels four times as small resolve waves of which the larger ones only know how many stand in each other's way. A few
// moments, because a coarse picture of glitter has few pixels that shine.
TEST_F(OceanEnergyTest, IsTheSameAtOnceTwiceAndFourTimesTheResolution) {
  constexpr int kMoments = 3;
  for (const char* name : kLights) {
    OceanScene scene(gpu(), device(), name);
    glm::dvec3 means[3] = {};
    for (std::uint32_t i = 0; i < 3; ++i) scene.addView({kSmallest.width << i, kSmallest.height << i});
    for (int moment = 0; moment < kMoments; ++moment) {
      scene.setTime(scene.scene().time + 10 * moment);
      for (std::size_t i = 0; i < 3; ++i) means[i] += farRadiance(scene.draw(i, support::fromAbove(scene.scene())));
    }
    expectEqual(means[1], means[0], std::string(name) + " 2x");
    expectEqual(means[2], means[0], std::string(name) + " 4x");
    expectEqual(means[2], means[1], std::string(name) + " 4x to 2x");
  }
}

// What the sheet is too coarse to hide is hidden in shading.
TEST_F(OceanEnergyTest, IsTheSameOnAnySheet) {
  for (const char* name : kLights) {
    glm::dvec3 means[2] = {};
    for (int sheet = 0; sheet < 2; ++sheet) {
      OceanScene scene(gpu(), device(), name, sheet == 0 ? 3.0f : 24.0f);
      const std::size_t view = scene.addView({2 * kSmallest.width, 2 * kSmallest.height});
      for (int moment = 0; moment < 3; ++moment) {
        scene.setTime(scene.scene().time + 10 * moment);
        means[sheet] += farRadiance(scene.draw(view, support::fromAbove(scene.scene())));
      }
    }
    expectEqual(means[1], means[0], name);
  }
}

}  // namespace
