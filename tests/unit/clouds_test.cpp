#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "physics/clouds.glsl"

namespace {

namespace physics = pelagic::physics;
constexpr double kPi = std::numbers::pi;
constexpr double kRadius = 6371e3;

double altitude(double h, double mu, double t) {
  return std::sqrt((kRadius + h) * (kRadius + h) + 2 * (kRadius + h) * mu * t + t * t) - kRadius;
}

TEST(Clouds, WeatherTurnsFromFieldsToOpenSeaAndBack) {
  EXPECT_EQ(physics::cloudWeather(glm::vec2(0)), 0);
  double open = 0, fields = 0;
  constexpr int kSteps = 48;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const glm::vec2 place = glm::vec2(i, j) * (physics::kCloudWeatherTiles / kSteps);
      const float weather = physics::cloudWeather(place);
      EXPECT_GE(weather, 0);
      EXPECT_LE(weather, 1);
      EXPECT_NEAR(physics::cloudWeather(place + glm::vec2(physics::kCloudWeatherTiles, -physics::kCloudWeatherTiles)),
                  weather, 1e-4);
      open += weather > 0.9f;
      fields += weather < 0.1f;
    }
  }
  EXPECT_GT(open, 0.2 * kSteps * kSteps);
  EXPECT_GT(fields, 0.1 * kSteps * kSteps);
  // The sun's ray at 30 degrees meets the middle of the layer, 1000 m up, sqrt(3) km toward the sun.
  const glm::vec3 sun(std::sqrt(0.75f), 0.5f, 0);
  EXPECT_NEAR(physics::cloudsTowardSun({1, 2}, sun, 500, 1500, 0.001f).x, 1 + std::sqrt(3.0), 1e-5);
}

TEST(Clouds, SpanIsWhereARayWalkedStepByStepIsInTheLayer) {
  constexpr double kBase = 800, kTop = 1500, kStep = 0.5;
  for (const double h : {2.0, 500.0, 900.0, 1400.0, 3000.0, 10e3}) {
    for (const double degrees : {-80.0, -20.0, -5.0, -1.0, 1.0, 5.0, 20.0, 80.0}) {
      const double mu = std::sin(degrees * kPi / 180);
      double entry = -1, exit = -1;
      for (double t = 0; t < 4e5; t += kStep) {
        const double at = altitude(h, mu, t);
        const bool inside = at >= kBase && at <= kTop;
        if (at < 0 && entry < 0) break;
        if (inside && entry < 0) entry = t;
        if (!inside && entry >= 0) {
          exit = t;
          break;
        }
      }
      const glm::vec2 span = physics::cloudSpan(static_cast<float>(h), static_cast<float>(mu), kBase, kTop);
      if (entry < 0) {
        EXPECT_EQ(span.x, span.y) << h << ' ' << degrees;
        continue;
      }
      EXPECT_NEAR(span.x, entry, 1 + 2e-4 * entry) << h << ' ' << degrees;
      EXPECT_NEAR(span.y, std::min(exit, entry + physics::kCloudLongest * (kTop - kBase)), 1 + 2e-4 * exit)
          << h << ' ' << degrees;
    }
  }
}

TEST(Clouds, DensityOnAWayIsTheMeanOfItsSamples) {
  for (const float a : {-2.f, -0.3f, 0.1f, 0.4f, 0.9f}) {
    for (const float b : {-1.f, -0.3f, 0.1f, 0.4001f, 0.7f, 3.f}) {
      double sum = 0;
      constexpr int kCount = 10000;
      for (int i = 0; i < kCount; ++i) {
        const float part = (static_cast<float>(i) + 0.5f) / kCount;
        sum += static_cast<double>(physics::cloudDensity(a + (b - a) * part)) / kCount;
      }
      EXPECT_NEAR(static_cast<double>(physics::cloudDensityBetween(a, b)), sum, 1e-3) << a << ' ' << b;
    }
  }
}

TEST(Clouds, EachOrderOfScatteringCarriesItsShare) {
  const auto whole = [](double q) {
    double sum = 0;
    constexpr int kCount = 20000;
    for (int i = 0; i < kCount; ++i) {
      const double mu = 2 * (i + 0.5) / kCount - 1;
      sum += 4 * kPi / kCount *
             static_cast<double>(physics::cloudScattering(static_cast<float>(mu), static_cast<float>(q), 0));
    }
    return sum;
  };
  EXPECT_NEAR(whole(1), 1 + 0.75 + 0.56 + 1.7, 5e-3);
  EXPECT_NEAR(whole(0.5), std::pow(0.5, 4) + 0.75 * 0.25 + 0.56 * 0.5 + 1.7 * std::sqrt(0.5), 5e-3);
  EXPECT_EQ(physics::cloudScattering(0.3f, 0, 0), 0);
  EXPECT_GT(physics::cloudScattering(1, 1, 0.5f), 20 * physics::cloudScattering(-1, 1, 0.5f))
      << "forward is where the sun is";
}

TEST(Clouds, LightComesDownThroughThickOnes) {
  // Of a layer of the vertical depth 20 two streams let 1/(1 + 3/4 * 0.15 * 20) through, wherever the sun stands: on
  // its way the depth is that over the sine of its elevation.
  for (const double sunY : {0.35, 0.6, 1.0}) {
    const auto q = static_cast<float>(std::exp(-5 / sunY)), y = static_cast<float>(sunY);
    EXPECT_NEAR(static_cast<double>(physics::cloudDiffuse(q, y)), 1 / 3.25, 1e-5) << sunY;
    // Less than half of what reaches the layer, the same in all directions: radiance times pi.
    const double down = kPi * static_cast<double>(physics::cloudScattering(0.1f, q, y));
    EXPECT_NEAR(down, 0.45 * std::min(sunY, 1.7 / 4) / 3.25, 0.01 * sunY) << sunY;
  }
  // A sun at the horizon or below: six times the depth along the layer.
  for (const float sunY : {0.1f, 0.02f, -0.01f}) {
    EXPECT_NEAR(static_cast<double>(physics::cloudDiffuse(std::exp(-15.f), sunY)), 1 / (1 + 0.1125 * 10), 1e-4) << sunY;
  }
  EXPECT_EQ(physics::cloudDiffuse(1, 0.5f), 1);
  EXPECT_GT(physics::cloudDiffuse(0, 1), 0) << "no depth is too great";
}

}  // namespace
