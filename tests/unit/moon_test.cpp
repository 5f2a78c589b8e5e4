#include <gtest/gtest.h>

#include <cmath>

#include "physics/moon.glsl"

namespace {

namespace physics = pelagic::physics;

TEST(Moon, PhasesAreAsBrightAsMeasured) {
  EXPECT_NEAR(physics::moonStrength(1), 2.35e-6, 1e-8);
  // Magnitudes of Allen (1973): half moon -10.0 against -12.73, a quarter of the disc -8.6.
  EXPECT_NEAR(-2.5 * std::log10(physics::moonStrength(0.5f) / physics::moonStrength(1)), 2.60, 0.02);
  EXPECT_NEAR(-2.5 * std::log10(physics::moonStrength(0.25f) / physics::moonStrength(1)), 3.12 + 0.83, 0.03);
  EXPECT_LT(physics::moonStrength(0), 1e-3f * physics::moonStrength(1));
}

TEST(Moon, TintLeavesTheLuminance) {
  const glm::vec3 tint = physics::kMoonTint;
  EXPECT_NEAR(0.2126f * tint.r + 0.7152f * tint.g + 0.0722f * tint.b, 1, 0.01);
}

TEST(Stars, AreAsManyAndAsBrightAsReal) {
  constexpr int kCount = 98304;
  int toSixAndAHalf = 0, toThird = 0;
  for (int i = 0; i < kCount; ++i) {
    const float magnitude = physics::starMagnitude((static_cast<float>(i) + 0.5f) / kCount, kCount);
    toSixAndAHalf += magnitude < 6.5f;
    toThird += magnitude < 3;
  }
  EXPECT_NEAR(toSixAndAHalf, 9100, 20);
  EXPECT_NEAR(toThird, 9100 * std::pow(10, -0.5 * 3.5), 3) << "160 with 10^0.5 to the magnitude; catalogues have 170";
  EXPECT_NEAR(physics::starStrength(0) * 1.334e5, 2.54e-6, 1e-8) << "lux";
  EXPECT_NEAR(physics::starStrength(5) / physics::starStrength(0), 0.01, 1e-4);
}

}  // namespace
