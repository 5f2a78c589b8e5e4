#include <gtest/gtest.h>

#include <cmath>

#include "physics/optics.glsl"
#include "physics/tone.glsl"

namespace {

using namespace pelagic;
using glm::vec3;

TEST(Optics, ReflectanceIsGordons) {
  const vec3 a{0.465f, 0.0600f, 0.0150f};
  const vec3 b{0.0010f, 0.0016f, 0.0034f};
  const vec3 r = physics::deepReflectance(a, b);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(r[i], 0.33 * b[i] / (a[i] + b[i]), 1e-7);
  // Blue, and far too dark for a swimming pool.
  EXPECT_GT(r.z, 5 * r.y);
  EXPECT_LT(r.z, 0.08f);
}

TEST(Optics, WaterLeavingRadiance) {
  const vec3 l = physics::waterLeaving(vec3(0.06f));
  EXPECT_NEAR(l.x, 0.96 * 0.06 / (1.34 * 1.34 * 4 * (1 - 0.48 * 0.06)), 1e-7);
  // Even a medium that sends everything back returns less than came in.
  const double most = physics::waterLeaving(vec3(1)).x;
  EXPECT_LT(most * M_PI, 1);
}

TEST(Optics, BubblesBelowFoamAreSeenThroughTheWaterAboveThem) {
  const vec3 a{0.465f, 0.0600f, 0.0150f};
  const vec3 fresh = physics::plumeLeaving(a, 1), old = physics::plumeLeaving(a, 0.3f);
  for (int i = 0; i < 3; ++i) {
    const double seen = std::exp(-2 * 1.5 * static_cast<double>(a[i]));
    const auto leaving = [&](double r) { return 0.96 * r / (1.34 * 1.34 * 4 * (1 - 0.48 * r)); };
    EXPECT_NEAR(fresh[i], leaving(0.25 * seen), 1e-7);
    EXPECT_NEAR(old[i], leaving(0.3 * 0.25 * seen), 1e-7);
  }
  EXPECT_EQ(physics::plumeLeaving(a, 0), vec3(0));
}

TEST(Optics, ThinWaterIsLessOpaque) {
  EXPECT_FLOAT_EQ(physics::tintOpacity(0, 0.2f, 4), 0.2f);
  EXPECT_FLOAT_EQ(physics::tintOpacity(1, 0.2f, 4), 0.6f);
  EXPECT_FLOAT_EQ(physics::tintOpacity(4, 0.2f, 4), 1.0f);
  EXPECT_FLOAT_EQ(physics::tintOpacity(100, 0.2f, 4), 1.0f);
}

TEST(Optics, EnteringIrradianceLosesWhatTheSurfaceReflects) {
  const double flat = std::pow(0.34 / 2.34, 2);
  EXPECT_NEAR(physics::enteringIrradiance(vec3(1), 1, vec3(0)).x, 1 - flat, 1e-6);
  EXPECT_EQ(physics::enteringIrradiance(vec3(1), -0.1f, vec3(0)).x, 0);
  double diffuse = 0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double c = (i + 0.5) / kSteps;
    diffuse += 2 * c * physics::fresnelReflectance(static_cast<float>(c), physics::kWaterIndex) / kSteps;
  }
  EXPECT_NEAR(physics::kDiffuseReflectance, diffuse, 1e-4);
}

TEST(Tone, SrgbWithinAHundredthOfAStep) {
  for (double x = 0; x <= 1; x += 0.0005) {
    const double exact = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    EXPECT_NEAR(physics::encodeSrgb(vec3(static_cast<float>(x))).x, exact, 6e-5) << x;
  }
}

TEST(Tone, CurveKeepsGreyRisesAndNeverClips) {
  EXPECT_NEAR(physics::filmCurve(vec3(0.18f)).x, 0.18, 1e-5);
  EXPECT_EQ(physics::filmCurve(vec3(0)).x, 0);
  float last = 0;
  for (float x = 1e-4f; x < 60000; x *= 1.1f) {
    const vec3 y = physics::filmCurve(vec3(x));
    EXPECT_EQ(y.x, y.y);
    EXPECT_EQ(y.x, y.z);
    EXPECT_GT(y.x, last);
    EXPECT_LT(y.x, 1);
    last = y.x;
  }
  EXPECT_LT(physics::filmCurve(vec3(16)).x, 0.985f);
}

}  // namespace
