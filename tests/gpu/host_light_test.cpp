#include <limits>

#include "host_light_fixture.hpp"

namespace {

using namespace pelagic;
using support::SyntheticScene;

class BallLightTest : public support::HostLightTest {
 protected:
  /// What a point mirrors of an even ball, summed over its disc in the sky.
  static double mirroredBall(const glm::dvec3& v, const glm::dvec3& ball, double radius, double intensity) {
    const double distance = glm::length(ball), edge = std::asin(radius / distance);
    const glm::dvec3 axis = ball / distance;
    const glm::dvec3 across = glm::normalize(glm::cross(axis, glm::dvec3(0.3, -0.2, 0.9)));
    const glm::dvec3 other = glm::cross(axis, across);
    const double radiance = intensity / (kPi * radius * radius);
    constexpr int kRings = 40, kSectors = 64;
    double sum = 0;
    for (int i = 0; i < kRings; ++i) {
      const double angle = edge * (i + 0.5) / kRings;
      for (int j = 0; j < kSectors; ++j) {
        const double turn = 2 * kPi * (j + 0.5) / kSectors;
        const glm::dvec3 around = std::cos(turn) * across + std::sin(turn) * other;
        const double solidAngle = std::sin(angle) * edge / kRings * 2 * kPi / kSectors;
        sum += radiance * solidAngle * mirroredFrom(v, std::cos(angle) * axis + std::sin(angle) * around);
      }
    }
    return sum;
  }
};

TEST_F(BallLightTest, FarBallIsTheSun) {
  // As large as the sun at 100 km, in a direction that tells x from z; its light in water, glint and foam.
  const glm::dvec3 toward = glm::normalize(glm::dvec3(0.55, 0.5, -0.7));
  const glm::vec3 irradiance(0.7f, 0.5f, 0.3f);
  for (const float foam : {0.0f, 0.6f}) {
    SyntheticScene sunlit = darkScene({49, 37}, 0.6, 0.5), lit = darkScene({49, 37}, 0.6, 0.5);
    sunlit.foam = lit.foam = foam;
    sunlit.light.sunDirection = glm::vec4(toward, std::cos(kSunAngularRadius));
    sunlit.light.sunIrradiance = glm::vec4(irradiance, 0);
    sunlit.light.sunRadiance = glm::vec4(irradiance / static_cast<float>(kPi * std::pow(kSunAngularRadius, 2)), 1);
    sunlit.render(device());
    constexpr double kFar = 1e5;
    lit.lights = {{overTheSea(lit, kFar * toward), kFar * kSunAngularRadius, irradiance * 1e10f}};
    lit.render(device());
    double brightest = 0;
    for (std::uint32_t y = 0; y < 37; ++y) {
      for (std::uint32_t x = 0; x < 49; ++x) {
        const glm::dvec3 expected(sunlit.radianceAt(x, y)), seen(lit.radianceAt(x, y));
        EXPECT_LT(glm::length(seen - expected), 2e-3 * glm::length(expected)) << x << ' ' << y;
        brightest = std::max(brightest, expected.r);
      }
    }
    EXPECT_GT(brightest, 0.01);
  }
}

TEST_F(BallLightTest, LightFallsWithTheSquareOfTheDistance) {
  // Straight down, the light at the zenith: F E p(0)/4 from the surface, p(0) = 1/(2 pi sigma^2), and light from
  // within.
  for (const double distance : {10.0, 40.0, 160.0}) {
    SyntheticScene scene = darkScene({9, 9}, 0, kPi / 2);
    scene.camera.projection = support::perspective(0.01, 1, 0.1, true);
    scene.camera.position.y = 1000;
    scene.light.skyIrradiance.w = 4;  // twilight's gain
    const double intensity = 50, irradiance = 4 * intensity / (distance * distance);
    scene.lights = {{scene.camera.position + glm::dvec3(0, distance - kAxial, 0), 0.05, glm::vec3(50)}};
    scene.render(device());
    const double share = std::pow(0.34 / 2.34, 2);
    const double glint = share * irradiance / (4 * 2 * kPi * kVariance);
    for (int c = 0; c < 3; ++c) {
      const double under = (1 - share) * irradiance * leaving(scene, c);
      EXPECT_NEAR(scene.radianceAt(4, 4)[c] / (glint + under), 1, 0.03) << distance << ' ' << c;
    }
  }
}

TEST_F(BallLightTest, GlintIsQuadratureOverTheBall) {
  constexpr std::uint32_t kSize = 33;
  for (const double pitch : {0.35, 0.8, 1.3}) {
    for (const double angle : {0.02, 0.1, 0.2}) {
      SyntheticScene scene = darkScene({kSize, kSize}, 0.4, pitch);
      scene.camera.projection = support::perspective(0.3, 1, 0.1, true);
      scene.medium.backscatter = glm::vec3(0);
      constexpr double kFar = 50, kIntensity = 30;
      // Above where the middle of the picture is mirrored to, a little to the side.
      const glm::dvec3 d = scene.directionAt(kSize / 2, kSize / 2);
      const glm::dvec3 toward = glm::normalize(glm::dvec3(d.x + 0.05, -d.y, d.z - 0.08));
      scene.lights = {{pointAt(scene, kSize / 2, kSize / 2) + kFar * toward, kFar * angle, glm::vec3(30)}};
      scene.render(device());
      double sum = 0, expectedSum = 0, worst = 0, brightest = 0;
      for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
          const glm::dvec3 v = -scene.directionAt(x, y), ball = scene.lights[0].position - pointAt(scene, x, y);
          const double expected = mirroredBall(v, ball, kFar * angle, kIntensity), seen = scene.radianceAt(x, y).g;
          sum += seen;
          expectedSum += expected;
          worst = std::max(worst, std::abs(seen - expected));
          brightest = std::max(brightest, expected);
        }
      }
      // A disc stands for a Gaussian of slopes: of a large one the sum is kept better than the shape.
      EXPECT_NEAR(sum / expectedSum, 1, angle > 0.1 ? 0.03 : 0.01) << pitch << ' ' << angle;
      if (angle <= 0.1) {
        EXPECT_LT(worst, 0.03 * brightest) << pitch << ' ' << angle;
      }
    }
  }
}

TEST_F(BallLightTest, LargeBallsAsideMakeNoGlintOfTheirOwn) {
  // Seen along the sea, facets that would mirror a lamp at the side are as steep as none: quadrature has 1e-15 of the
  // glint below a lamp ahead, a Gaussian in place of the disc 0.04.
  const auto ball = [](const SyntheticScene& scene, const glm::dvec3& toward) {
    return HostLight{pointAt(scene, 4, 4) + 50.0 * toward, 10, glm::vec3(30)};
  };
  const double ahead = glintSeenAlong(0, ball);
  EXPECT_GT(ahead, 0.01);
  EXPECT_LE(ahead, 0.1);
  for (const double aside : {0.7, 1.0}) EXPECT_LE(glintSeenAlong(aside, ball), 1e-4 * ahead) << aside;
}

TEST_F(BallLightTest, LightsAdd) {
  const auto drawn = [&](const std::vector<HostLight>& lights) {
    SyntheticScene scene = darkScene({16, 16}, 0, 0.6);
    scene.lights = lights;
    scene.render(device());
    return scene.radiance;
  };
  const HostLight a{{2103, 8, -3730}, 0.3, {3, 2, 1}}, b{{2090, 14, -3715}, 2, {1, 2, 9}};
  const auto first = drawn({a}), second = drawn({b}), both = drawn({a, b});
  std::vector<HostLight> many(kMostHostLights, HostLight{{0, 1, 0}, 1, glm::vec3(0)});
  many.front() = a;
  many.back() = b;
  const auto all = drawn(many);
  for (std::size_t i = 0; i < both.size(); ++i) {
    if (i % 4 == 3) continue;
    EXPECT_NEAR(both[i], first[i] + second[i], 1e-5f * both[i] + 1e-9f);
    EXPECT_NEAR(all[i], both[i], 1e-5f * both[i] + 1e-9f);
  }
}

TEST_F(BallLightTest, ErrorsNameFieldValueAndRange) {
  auto composite = Composite::create(device()).value();
  const auto refused = [&](const HostLight& light, const std::string& sentence) {
    const HostLight lights[] = {HostLight{}, light};
    const auto set = composite.setLights(lights);
    ASSERT_FALSE(set) << sentence;
    EXPECT_EQ(set.error().code, ErrorCode::invalidArgument);
    EXPECT_EQ(set.error().message, "HostLight 1's " + sentence);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused({{nan, 1, 0}, 1, {}}, "position.x is nan, it must be -1e9 to 1e9 m");
  refused({{0, -0.5, 0}, 1, {}}, "position.y is -0.5, it must be 0 to 1e5 m");
  refused({{0, 1, 2e9}, 1, {}}, "position.z is 2e+09, it must be -1e9 to 1e9 m");
  refused({{0, 1, 0}, 0, {}}, "radius is 0, it must be 1e-3 to 1e4 m");
  refused({{0, 1, 0}, 1, {0, -1, 0}}, "intensity.g is -1, it must be 0 to 1e12");
  refused({{0, 1, 0}, 1, {0, 0, std::numeric_limits<float>::infinity()}}, "intensity.b is inf, it must be 0 to 1e12");
  const auto many = composite.setLights(std::vector<HostLight>(17));
  ASSERT_FALSE(many);
  EXPECT_EQ(many.error().message, "there are 17 HostLights, there may be 0 to 16");
}

}  // namespace
