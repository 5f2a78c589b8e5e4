#include <cmath>

#include "composite_support.hpp"

namespace {

using support::SyntheticScene;

class OutlineTest : public support::GpuTest {};

constexpr std::uint32_t kSide = 96;

/// Near water below a straight line of the given slope [px/px] and, above it, sky or (farWater) water that haze hides.
struct Outline {
  double slope;
  bool steep;  ///< The line leans against the columns instead of the rows.
  bool farWater;

  double level(double along) const { return kSide / 2.0 + slope * (along - kSide / 2.0); }
  bool below(double x, double y) const { return steep ? x > level(y) : y > level(x); }
  /// Share of a pixel below the line.
  double cover(std::uint32_t x, std::uint32_t y) const {
    int inside = 0;
    for (int i = 0; i < 256; ++i) inside += below(x + (i % 16 + 0.5) / 16, y + (i / 16 + 0.5) / 16);
    return inside / 256.0;
  }
  bool isWater(std::uint32_t x, std::uint32_t y) const { return below(x + 0.5, y + 0.5); }
};

void draw(SyntheticScene& scene, pelagic::Device& device, const Outline& outline) {
  constexpr double kNear = 20, kFar = 20000;
  scene.light.mieExtinction = glm::vec4(glm::vec3(1e-3f), 1200);
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    const bool near = outline.isWater(i % kSide, i / kSide);
    scene.body[i] = near || outline.farWater;
    scene.depth[i] = near ? scene.depthAt(kNear) : outline.farWater ? scene.depthAt(kFar) : 0;
  }
  scene.withOutputs = false;
  scene.render(device);
}

/// Root mean square of what the picture's cover of the pixels on the line is off.
double coverError(const SyntheticScene& scene, const Outline& outline) {
  double sum = 0;
  int pixels = 0;
  for (std::uint32_t y = 8; y + 8 < kSide; ++y) {
    for (std::uint32_t x = 8; x + 8 < kSide; ++x) {
      const double cover = outline.cover(x, y);
      if (cover == 0 || cover == 1) continue;
      // Four pixels to either side of the line are the pure water and what is behind it.
      const std::uint32_t dx = outline.steep ? 4 : 0, dy = outline.steep ? 0 : 4;
      const double water = scene.radianceAt(x + dx, y + dy).x, beyond = scene.radianceAt(x - dx, y - dy).x;
      sum += std::pow((scene.radianceAt(x, y).x - beyond) / (water - beyond) - cover, 2);
      ++pixels;
    }
  }
  EXPECT_GE(pixels, 80);
  return std::sqrt(sum / pixels);
}

TEST_F(OutlineTest, StairsBecomeTheLineTheyStandFor) {
  for (const bool farWater : {false, true}) {
    for (const bool steep : {false, true}) {
      for (const double slope : {0.05, -0.11, 0.23, 0.4, -0.75, 0.9}) {
        const Outline outline{slope, steep, farWater};
        SyntheticScene scene(gpu(), {kSide, kSide});
        draw(scene, device(), outline);
        // 0.29 without smoothing; a step's ends are known to half a pixel, which counts most where steps are short.
        const double bound = std::abs(slope) < 0.8 ? 0.09 : 0.14;
        EXPECT_LT(coverError(scene, outline), bound)
            << slope << (steep ? " steep" : "") << (farWater ? " far water" : "");
      }
    }
  }
}

/// Rows and columns that step nowhere are left alone, and so is a plane however fast its distance grows.
TEST_F(OutlineTest, LeavesLevelLinesAndPlanesAlone) {
  SyntheticScene level(gpu(), {kSide, kSide});
  draw(level, device(), {0, false, false});
  for (std::uint32_t x = 0; x < kSide; ++x) EXPECT_EQ(level.radianceAt(x, kSide / 2 - 1).x, level.radianceAt(x, 0).x);

  // Seen from 2 m up to its horizon, where each row is far from the next; a checkerboard of hosts would show any
  // blending, here the air does: pixels are what they would be alone.
  SyntheticScene plane(gpu(), {kSide, kSide});
  plane.camera.rotation = support::lookAlong(0, 0.1);
  plane.light.mieExtinction = glm::vec4(glm::vec3(1e-3f), 1200);
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    const double down = -plane.directionAt(i % kSide, i / kSide).y;
    const double axial =
        2 / down * glm::dot(plane.directionAt(i % kSide, i / kSide), glm::dvec3(0, -std::sin(0.1), -std::cos(0.1)));
    plane.body[i] = down > 0;
    plane.depth[i] = down > 0 ? plane.depthAt(static_cast<float>(axial)) : 0;
  }
  plane.withOutputs = false;
  plane.render(device());
  for (std::uint32_t x = 0; x < kSide; x += 5) {
    for (std::uint32_t y = 1; y < kSide; ++y)
      EXPECT_GE(plane.radianceAt(x, y - 1).x, plane.radianceAt(x, y).x) << x << ' ' << y;
  }
}

}  // namespace
