#include <gtest/gtest.h>

#include <cmath>

#include "physics/air_path.glsl"

namespace {

using namespace pelagic;

TEST(AirPath, MeanDensityAgreesWithQuadrature) {
  for (const double height : {1.0, 60.0, 79.9, 80.1, 500.0, 8000.0, 1e5}) {
    double sum = 0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) sum += std::exp(-height * (i + 0.5) / kSteps / 8000) / kSteps;
    EXPECT_NEAR(physics::meanDensityBetween(0, static_cast<float>(height), 8000), sum, 2e-5) << height;
  }
}

TEST(AirPath, MeanDensityBetweenAltitudesEqualsQuadrature) {
  for (const auto& [a, b] : {std::pair{0.0, 1000.0}, {1000.0, 0.0}, {9000.0, 1200.0}, {50.0, 50.5}}) {
    double sum = 0;
    constexpr int kCount = 10000;
    for (int i = 0; i < kCount; ++i) sum += std::exp(-(a + (b - a) * (i + 0.5) / kCount) / 1200) / kCount;
    EXPECT_NEAR(physics::meanDensityBetween(static_cast<float>(a), static_cast<float>(b), 1200), sum, 2e-5)
        << a << ' ' << b;
  }
}

TEST(AirPath, ShareOfALayerBeforeAPoint) {
  const auto share = [](float eye, float point) { return physics::layerShareBefore(eye, point, 800, 1500); };
  // Below, above and across it, both ways.
  EXPECT_EQ(share(3, 0), 0);
  EXPECT_EQ(share(3, 700), 0);
  EXPECT_EQ(share(3, 1600), 1);
  EXPECT_EQ(share(3000, 0), 1);
  EXPECT_EQ(share(3000, 1600), 0);
  EXPECT_EQ(share(3000, 4000), 0);
  // Into it.
  EXPECT_FLOAT_EQ(share(3, 1010), 0.3f);
  EXPECT_FLOAT_EQ(share(3000, 1010), 0.7f);
  // From within: of the way up or down that is left.
  EXPECT_FLOAT_EQ(share(1000, 1100), 0.2f);
  EXPECT_FLOAT_EQ(share(1000, 900), 0.5f);
  EXPECT_EQ(share(1000, 0), 1);
  EXPECT_EQ(share(1000, 2000), 1);
  EXPECT_EQ(share(1000, 1000), 0);
  // Without clouds the layer is nowhere.
  EXPECT_EQ(physics::layerShareBefore(3, 100, 1e9f, 1e9f), 0);
}

}  // namespace
