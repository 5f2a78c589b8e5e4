/// Detail turns smoothly into roughness: no line across the sea where the maps change to another mip or a cascade ends.
#include <cmath>

#include "ocean_scene.hpp"

namespace {

using support::Drawn;
using support::OceanScene;

class OceanSeamTest : public support::GpuTest {};

/// Mean square of how neighbours in a row differ in the logarithm of their luminance.
double texture(const Drawn& drawn) {
  double sum = 0;
  for (std::uint32_t y = 0; y < drawn.extent.height; ++y) {
    for (std::uint32_t x = 1; x < drawn.extent.width; ++x) {
      const double step = std::log(drawn.luminanceAt(x, y) / drawn.luminanceAt(x - 1, y));
      sum += step * step;
    }
  }
  return sum / (1.0 * drawn.extent.height * (drawn.extent.width - 1));
}

// Straight down on the same water from ever higher, in steps of a 16th of an octave, where one cascade changes from mip
// to mip and another does. At the nearest mip alone one step halves the texture: -1.03; the blend leaves 0.18 of waves
// that come into the picture. The sun is high: of a low one few facets that lie steeply would glint, and come and go.
TEST_F(OceanSeamTest, TextureFadesSmoothlyWithDistance) {
  OceanScene scene(gpu(), device(), "noon-calm", 12,
                   [](common::Scene& high) { high.sky.sunElevation = glm::radians(48.0); });
  const std::size_t target = scene.addView({128, 128});
  scene.setTime(60);
  double last = 0;
  for (int i = 0; i <= 24; ++i) {
    const double height = 18 * std::exp2(i / 16.0);
    const double now = texture(scene.draw(target, {{0, height, 0}, {0.01, 0, 0}, 45}));
    if (i > 0) {
      EXPECT_LT(std::abs(std::log2(now / last)), 0.25) << height << " m";
    }
    last = now;
  }
}

}  // namespace
