#include <limits>

#include "host_light_fixture.hpp"

namespace {

using namespace pelagic;
using support::SyntheticScene;

class PanelLightTest : public support::HostLightTest {
 protected:
  /// A panel whose front looks toward `toward`, turned around that by `turn`, with sides of 2 `a` and 2 `b`.
  static HostLight panel(const glm::dvec3& place, const glm::dvec3& toward, double turn, double a, double b,
                         const glm::vec3& intensity) {
    const glm::dvec3 n = glm::normalize(toward), x = glm::normalize(glm::cross(n, glm::dvec3(0.1, 0.2, 0.9)));
    const glm::dvec3 y = glm::cross(n, x);
    return {place, 0.1, intensity, a * (std::cos(turn) * x + std::sin(turn) * y),
            b * (std::cos(turn) * y - std::sin(turn) * x)};
  }
  /// What a point mirrors of a panel, summed over it.
  static double mirroredPanel(const glm::dvec3& v, const glm::dvec3& point, const HostLight& light) {
    const glm::dvec3 area = 4.0 * glm::cross(light.halfWidth, light.halfHeight);
    const double radiance = light.intensity.g / glm::length(area);
    constexpr int kSteps = 40;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      for (int j = 0; j < kSteps; ++j) {
        const glm::dvec3 to = light.position - point + ((2 * i + 1.0) / kSteps - 1) * light.halfWidth +
                              ((2 * j + 1.0) / kSteps - 1) * light.halfHeight;
        const double r = glm::length(to), facing = std::max(-glm::dot(area, to), 0.0) / (kSteps * kSteps * r * r * r);
        sum += radiance * facing * mirroredFrom(v, to / r);
      }
    }
    return sum;
  }
};

TEST_F(PanelLightTest, GlintIsQuadratureOverThePanel) {
  constexpr std::uint32_t kSize = 33;
  constexpr double kFar = 50;
  struct Shape {
    double a, b;  // half the sides over the distance
    double aslant, turn;
  };
  for (const double pitch : {0.35, 1.3}) {
    for (const Shape& shape : {Shape{0.02, 0.02, 0, 0.3}, Shape{0.075, 0.02, 0.9, 0.6}, Shape{0.02, 0.075, 0.5, 0.2},
                               Shape{0.075, 0.06, 1.3, 1.1}, Shape{0.2, 0.1, 0.4, -0.4}}) {
      SyntheticScene scene = darkScene({kSize, kSize}, 0.4, pitch);
      scene.camera.projection = support::perspective(0.3, 1, 0.1, true);
      scene.medium.backscatter = glm::vec3(0);
      // Above where the middle of the picture is mirrored to, a little to the side.
      const glm::dvec3 d = scene.directionAt(kSize / 2, kSize / 2);
      const glm::dvec3 toward = glm::normalize(glm::dvec3(d.x + 0.05, -d.y, d.z - 0.08));
      const glm::dvec3 side = glm::normalize(glm::cross(toward, glm::dvec3(0.5, 0.3, -0.2)));
      const glm::dvec3 front = -std::cos(shape.aslant) * toward + std::sin(shape.aslant) * side;
      const HostLight light = panel(pointAt(scene, kSize / 2, kSize / 2) + kFar * toward, front, shape.turn,
                                    kFar * shape.a, kFar * shape.b, glm::vec3(30));
      scene.lights = {light};
      scene.render(device());
      double sum = 0, expectedSum = 0, worst = 0, brightest = 0;
      for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
          const double expected = mirroredPanel(-scene.directionAt(x, y), pointAt(scene, x, y), light);
          const double seen = scene.radianceAt(x, y).g;
          sum += seen;
          expectedSum += expected;
          worst = std::max(worst, std::abs(seen - expected));
          brightest = std::max(brightest, expected);
        }
      }
      const bool large = shape.a > 0.1;
      EXPECT_NEAR(sum / expectedSum, 1, large ? 0.03 : 0.01) << pitch << ' ' << shape.a << ' ' << shape.b;
      if (!large) {
        EXPECT_LT(worst, 0.03 * brightest) << pitch << ' ' << shape.a << ' ' << shape.b;
      }
    }
  }
}

TEST_F(PanelLightTest, FarPanelIsABallTimesItsCosine) {
  // In glint, water and foam, from one side only.
  for (const float foam : {0.0f, 0.6f}) {
    for (const double aslant : {0.0, 1.0}) {
      SyntheticScene ball = darkScene({49, 37}, 0.6, 0.5), flat = darkScene({49, 37}, 0.6, 0.5);
      ball.foam = flat.foam = foam;
      ball.light.skyIrradiance.w = flat.light.skyIrradiance.w = 4;  // twilight's gain
      constexpr double kFar = 1000;
      const glm::dvec3 toward = glm::normalize(glm::dvec3(0.55, 0.5, -0.7)),
                       place = ball.camera.position + kFar * toward;
      const glm::dvec3 side = glm::normalize(glm::cross(toward, glm::dvec3(0, 1, 0)));
      const glm::dvec3 front = -std::cos(aslant) * toward + std::sin(aslant) * side;
      const glm::vec3 intensity(7e5f, 5e5f, 3e5f);
      ball.lights = {{place, 1, intensity * static_cast<float>(std::cos(aslant))}};
      flat.lights = {panel(place, front, 0.4, 1, 1.5, intensity)};
      ball.render(device());
      flat.render(device());
      double brightest = 0;
      for (std::uint32_t y = 0; y < 37; ++y) {
        for (std::uint32_t x = 0; x < 49; ++x) {
          const glm::dvec3 expected(ball.radianceAt(x, y)), seen(flat.radianceAt(x, y));
          // Its middle is as far from all of them as the ball's, but the side that they see of it changes a little.
          EXPECT_LT(glm::length(seen - expected), (aslant > 0 ? 0.04 : 2e-3) * glm::length(expected)) << x << ' ' << y;
          brightest = std::max(brightest, expected.r);
        }
      }
      EXPECT_GT(brightest, 0.01);
      std::swap(flat.lights[0].halfWidth, flat.lights[0].halfHeight);
      flat.render(device());
      for (std::size_t i = 0; i < flat.radiance.size(); ++i) ASSERT_EQ(flat.radiance[i], i % 4 == 3 ? 1 : 0);
    }
  }
}

TEST_F(PanelLightTest, NearPanelsLightFollowsLambert) {
  // Straight above, in its middle: for sides of 2a and distance d the irradiance is L 4 x/sqrt(1 + x^2) atan(x/sqrt(1 +
  // x^2)), x = a/d, with the intensity L 4 a^2. Only the light from within: facets far from level mirror the panel's
  // corners.
  for (const double distance : {0.5, 2.0, 8.0, 40.0}) {
    SyntheticScene scene = darkScene({9, 9}, 0, kPi / 2);
    scene.camera.projection = support::perspective(0.01, 1, 0.1, true);
    scene.camera.position.y = 1000;
    const auto rendered = [&](float backscatter) {
      scene.medium.backscatter = glm::vec3(backscatter);
      scene.render(device());
      return static_cast<double>(scene.radianceAt(4, 4).g);
    };
    constexpr double kHalf = 2, kIntensity = 50;
    scene.lights = {panel(scene.camera.position + glm::dvec3(0, distance - kAxial, 0), {0, -1, 0}, 0.3, kHalf, kHalf,
                          glm::vec3(50))};
    const double glint = rendered(0), seen = rendered(0.01f) - glint;
    const double radiance = kIntensity / (4 * kHalf * kHalf), x = kHalf / distance, s = x / std::sqrt(1 + x * x);
    const double irradiance = radiance * 4 * s * std::atan(s);
    const double share = std::pow(0.34 / 2.34, 2);
    EXPECT_NEAR(seen / ((1 - share) * irradiance * leaving(scene, 1)), 1, 0.01) << distance;
    // No mirror image is brighter than what it mirrors, of which the sea reflects 2 %; also where the panel fills
    // the sky.
    EXPECT_LE(glint, 1.001 * share * radiance) << distance;
    const double whole = mirroredPanel({0, 1, 0}, pointAt(scene, 4, 4), scene.lights[0]);
    EXPECT_NEAR(glint / std::min(whole, share * radiance), 1, 0.02) << distance;
  }
}

TEST_F(PanelLightTest, ACalmSeaShowsNoMoreThanThePanel) {
  // Smooth water straight below a small far panel: the glint of a point would be 1000 times as bright.
  SyntheticScene scene = darkScene({9, 9}, 0, kPi / 2);
  scene.camera.projection = support::perspective(0.01, 1, 0.1, true);
  scene.camera.position.y = 1000;
  scene.waves.unresolved = {1e-8, 1e-8};
  scene.medium.backscatter = glm::vec3(0);
  scene.lights = {panel(scene.camera.position + glm::dvec3(0, 80, 0), {0, -1, 0}, 0, 0.5, 0.1, glm::vec3(30))};
  scene.render(device());
  EXPECT_NEAR(scene.radianceAt(4, 4).g / (std::pow(0.34 / 2.34, 2) * 30 / (4 * 0.5 * 0.1)), 1, 0.01);
}

TEST_F(PanelLightTest, LargePanelsAsideMakeNoGlintOfTheirOwn) {
  // As the ball's test: quadrature has 3e-15 of the glint ahead.
  const auto aslant = [](const SyntheticScene& scene, const glm::dvec3& toward) {
    return panel(pointAt(scene, 4, 4) + 50.0 * toward, -toward, 0.5, 10, 5, glm::vec3(30));
  };
  const double ahead = glintSeenAlong(0, aslant);
  EXPECT_GT(ahead, 0.01);
  EXPECT_LE(ahead, 0.1);
  for (const double aside : {0.7, 1.0}) EXPECT_LE(glintSeenAlong(aside, aslant), 1e-3 * ahead) << aside;
}

TEST_F(PanelLightTest, ErrorsNameFieldValueAndRange) {
  const auto refused = [&](const glm::dvec3& a, const glm::dvec3& b, const std::string& sentence) {
    const HostLight lights[] = {HostLight{}, HostLight{{0, 3, 0}, 0.1, {1, 1, 1}, a, b}};
    const auto valid = validate(lights);
    ASSERT_FALSE(valid) << sentence;
    EXPECT_EQ(valid.error().code, ErrorCode::invalidArgument);
    EXPECT_EQ(valid.error().message, "HostLight 1's " + sentence);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused({1, 0, 0}, {0, 0, 0}, "halfHeight's length is 0, it must be 1e-3 to 1e4 m");
  refused({0, 0, 0}, {0, 1, 0}, "halfWidth's length is 0, it must be 1e-3 to 1e4 m");
  refused({nan, 0, 0}, {0, 1, 0}, "halfWidth's length is nan, it must be 1e-3 to 1e4 m");
  refused({0, 0, 2e4}, {0, 1, 0}, "halfWidth's length is 20000, it must be 1e-3 to 1e4 m");
  refused({1, 0, 0}, {0.3, 0.4, 0}, "cosine between halfWidth and halfHeight is 0.6, it must be 0 to within 1e-3");
  refused({1, 0, 0}, {2, 0, 0}, "cosine between halfWidth and halfHeight is 1, it must be 0 to within 1e-3");
  refused({1, 0, 0}, {0, 4, 0}, "lowest corner's y is -1, it must be 0 to 1e5 m");
  const HostLight good[] = {{{0, 3, 0}, 0, {1, 1, 1}, {1, 0, 0}, {0, 3, 0}}};
  EXPECT_TRUE(validate(good));
}

}  // namespace
