#include <cmath>
#include <numbers>

#include "composite_support.hpp"

namespace {

using namespace pelagic;
using support::SyntheticScene;

constexpr std::uint32_t kSide = 256;

class CompositeSlicksTest : public support::GpuTest {
 protected:
  /// A sea whose slopes have the variance 0.01 in the maps and 0.02 in what no cascade holds, seen in pixels 60 m
  /// apart.
  SyntheticScene makeScene() {
    SyntheticScene scene(gpu(), {kSide, kSide});
    scene.fillWater(4);
    scene.spread(60);
    scene.waves.slopeCovariance[0] = {0.01, 0.01, 0};
    scene.moments = {0.01f, 0.01f, 0, 0};
    scene.waves.unresolved = {0.02, 0.02};
    return scene;
  }

  /// Slope variance per pixel over that without slicks, less 1.
  std::vector<double> draw(SyntheticScene& scene, double slicks) {
    scene.medium.slicks = 0;
    scene.render(device());
    const std::vector<float> even = scene.slopeVariance;
    scene.medium.slicks = slicks;
    scene.render(device());
    std::vector<double> change;
    for (std::size_t i = 0; i < even.size(); i += 2) {
      change.push_back(static_cast<double>(scene.slopeVariance[i] / even[i]) - 1);
    }
    return change;
  }
};

double deviation(const std::vector<double>& change) {
  double squares = 0;
  for (const double c : change) squares += c * c;
  return std::sqrt(squares / static_cast<double>(change.size()));
}

/// Product of neighbours along x and along z in the mean.
glm::dvec2 products(const std::vector<double>& change) {
  glm::dvec2 sum(0);
  for (std::uint32_t y = 0; y + 1 < kSide; ++y) {
    for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
      const std::size_t i = y * kSide + x;
      sum += change[i] * glm::dvec2(change[i + 1], change[i + kSide]);
    }
  }
  return sum / static_cast<double>((kSide - 1) * (kSide - 1));
}

TEST_F(CompositeSlicksTest, VaryTheSlopesOfShortWavesAboutTheirMean) {
  SyntheticScene scene = makeScene();
  for (const double length : {0.5, 100.0}) {
    scene.waves.layout.cascades[0].length = length;
    // Of a long cascade's waves, a third of the variance here, nothing is varied.
    const double varied = length > 24 ? 2.0 / 3 : 1;
    for (const double slicks : {0.2, 0.4}) {
      const std::vector<double> change = draw(scene, slicks);
      double mean = 0;
      for (const double c : change) mean += c / (kSide * kSide);
      EXPECT_NEAR(mean, 0, 0.02) << length << ' ' << slicks;
      EXPECT_NEAR(deviation(change), varied * slicks, 0.1 * slicks) << length;
    }
  }
}

TEST_F(CompositeSlicksTest, LieInBandsAlongTheWind) {
  SyntheticScene scene = makeScene();
  const glm::dvec2 toX = products(draw(scene, 0.4));
  EXPECT_GT(toX.x, 1.3 * toX.y);
  scene.waves.windDirection = std::numbers::pi / 2;
  const glm::dvec2 toZ = products(draw(scene, 0.4));
  EXPECT_GT(toZ.y, 1.3 * toZ.x);
}

TEST_F(CompositeSlicksTest, StayWhereTheyAreAndRepeatAfterTheirPeriod) {
  SyntheticScene scene = makeScene();
  const std::vector<double> here = draw(scene, 0.4);
  scene.camera.position.x += 60;
  const std::vector<double> moved = draw(scene, 0.4);
  scene.camera.position.x += 32768 - 60;
  const std::vector<double> period = draw(scene, 0.4);
  for (std::uint32_t y = 0; y < kSide; ++y) {
    for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
      const std::size_t i = y * kSide + x;
      ASSERT_NEAR(moved[i], here[i + 1], 0.01) << x << ' ' << y;
      ASSERT_NEAR(period[i], here[i], 0.01) << x << ' ' << y;
    }
  }
}

TEST_F(CompositeSlicksTest, AreTheirMeanWhereAPixelHoldsMany) {
  SyntheticScene scene = makeScene();
  scene.fillWater(400000);
  EXPECT_LT(deviation(draw(scene, 0.4)), 1e-5);
}

}  // namespace
