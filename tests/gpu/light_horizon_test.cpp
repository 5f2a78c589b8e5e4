#include "host_light_fixture.hpp"

namespace {

using namespace pelagic;
using support::SyntheticScene;

class LightHorizonTest : public support::HostLightTest {
 protected:
  /// Calm water straight below an eye 3 km up on a planet: what it shows is the light that entered it.
  SyntheticScene below(double planetRadius) {
    SyntheticScene scene = darkScene({9, 9}, 0, kPi / 2);
    scene.camera.projection = support::perspective(0.001, 1, 0.1, true);
    scene.camera.position.y = 3000;
    scene.planetRadius = planetRadius;
    scene.fillWater(3000);
    scene.waves.unresolved = {1e-6, 1e-6};  // no glint but that of a light straight above
    return scene;
  }
  /// Irradiance that entered the scene's water, over the sine of the light's elevation and the loss at the surface.
  double entered(SyntheticScene& scene, const HostLight& light, double up) {
    scene.lights = {light};
    scene.render(device());
    return scene.radianceAt(4, 4).g / (leaving(scene, 1, up) * up * (1 - std::pow(0.34 / 2.34, 2)));
  }
};

TEST_F(LightHorizonTest, HeightIsOverTheCurvedSea) {
  // In closed form: the angle t around the planet, sin t = D/R, and a lamp (R + h)(sin t, cos t) from the centre.
  struct Case {
    double radius, distance, height;
  };
  for (const Case& c : {Case{kEarthRadius, 15000, 20}, Case{kEarthRadius, 20000, 40}, Case{kEarthRadius, 20000, 32},
                        Case{1e5, 20000, 2100}, Case{1e5, 20000, 9000}, Case{1e5, 60000, 90000}}) {
    SyntheticScene scene = below(c.radius);
    const double sine = c.distance / c.radius, cosine = std::sqrt(1 - sine * sine);
    const double x = (c.radius + c.height) * sine, y = (c.radius + c.height) * cosine - c.radius;
    const double r = std::hypot(x, y);
    const glm::dvec2 along(0.6, -0.8);
    const glm::dvec3 place(2100 + c.distance * along.x, c.height, -3700 + c.distance * along.y);
    const float intensity = static_cast<float>(r * r);
    EXPECT_NEAR(entered(scene, {place, 1e-2, glm::vec3(intensity)}, y / r), 1, 3e-3) << c.distance << ' ' << c.height;
    // A panel that looks back toward the eye's foot, level where it stands: its front is (-cos t, sin t) in the plane.
    const glm::dvec3 side(-along.y, 0, along.x);
    const double facing = (x * cosine - y * sine) / r;
    EXPECT_NEAR(entered(scene, {place, 0, glm::vec3(intensity), 1e-2 * side, {0, 1e-2, 0}}, y / r), facing,
                3e-3 * facing);
  }
}

TEST_F(LightHorizonTest, NoLightComesFromBehindTheHorizon) {
  struct Case {
    double radius, distance, height;
  };
  for (const Case& c : {Case{kEarthRadius, 20000, 20}, Case{kEarthRadius, 20000, 30}, Case{1e5, 20000, 2050},
                        Case{1e5, 99000, 1e5}, Case{1e5, 3e5, 1e5}}) {
    SyntheticScene scene = below(c.radius);
    EXPECT_EQ(entered(scene, {{2100 + c.distance, c.height, -3700}, 1, glm::vec3(1e11f)}, 0.5), 0) << c.height;
  }
}

TEST_F(LightHorizonTest, WaterThatStandsHigherSeesFarther) {
  // A face of foam turned to a lamp 20 m high, which is in sight up to sqrt(2 R 20 m) and sqrt(2 R w) more from water
  // of the height w: 15.96 km from sea level, 23.10 km from 4 m.
  for (const auto& [water, horizon] : {std::pair{0.0f, 15964.0}, {4.0f, 23103.0}}) {
    for (const double part : {0.99, 1.01}) {
      SyntheticScene scene = below(kEarthRadius);
      scene.fillWater(3000 - water);
      scene.gradient = {-0.25f, 0, 0, 0};
      scene.foam = 0.9f;
      scene.lights = {{{2100 + part * horizon, 20, -3700}, 0.1, glm::vec3(1e9f)}};
      scene.render(device());
      const float seen = scene.radianceAt(4, 4).g;
      EXPECT_EQ(seen > 0, part < 1) << water << ' ' << part << ": " << seen;
    }
  }
}

TEST_F(LightHorizonTest, ALighthouseLightsTheWaterUpToItsHorizon) {
  // 20 m high and 20 km off it lights what is within sqrt(2 R 20 m) = 15.96 km of it: from 4.04 km off the eye on.
  SyntheticScene scene = darkScene({9, 240}, 0, 0.015);
  scene.camera.position.y = 60;
  scene.camera.projection = support::perspective(0.03, 9.0 / 240, 0.1, true);
  const double radius = kEarthRadius;
  std::vector<double> away(240, -1);
  for (std::uint32_t y = 0; y < 240; ++y) {
    for (std::uint32_t x = 0; x < 9; ++x) {
      const glm::dvec3 d = scene.directionAt(x, y);
      const double b = (radius + 60) * d.y, c = 60 * (2 * radius + 60), root = b * b - c;
      if (d.y >= 0 || root < 0) continue;
      const double t = c / (std::sqrt(root) - b);
      const std::size_t i = y * 9 + x;
      scene.body[i] = 1;
      scene.depth[i] = scene.depthAt(static_cast<float>(-t * d.z));
      scene.position[i] = {static_cast<float>(t * d.x), static_cast<float>(t * d.z)};
      if (x == 4) away[y] = t;
    }
  }
  scene.lights = {{{2100, 20, -3700 - 20000}, 0.2, glm::vec3(1e9f)}};
  scene.render(device());
  int dark = 0, bright = 0;
  for (std::uint32_t y = 0; y < 240; ++y) {
    if (away[y] < 0) continue;
    const float seen = scene.radianceAt(4, y).g;
    if (away[y] < 3900) {
      EXPECT_EQ(seen, 0) << away[y];
      ++dark;
    } else if (away[y] > 4200 && away[y] < 19000) {
      EXPECT_GT(seen, 1e-3) << away[y];
      ++bright;
    }
  }
  EXPECT_GT(dark, 5);
  EXPECT_GT(bright, 20);
}

TEST_F(LightHorizonTest, WavesHigherThanALampLookDownOnIt) {
  // A crest of 4 m beside a lamp of 2 m: its face turns to it, the glint is that of a lamp on a planet without a curve.
  const auto seen = [&](double radius) {
    SyntheticScene scene = darkScene({9, 9}, 0, 0.2);
    scene.planetRadius = radius;
    scene.camera.position.y = 4 + kAxial * std::tan(0.2);
    scene.camera.projection = support::perspective(0.01, 1, 0.1, true);
    scene.gradient = {0, 0.25f, 0, 0};
    const glm::dvec3 point = pointAt(scene, 4, 4);
    scene.lights = {{{point.x, 2, point.z - 30}, 0.1, glm::vec3(10)}};
    scene.foam = 0.9f;
    scene.render(device());
    return scene.radianceAt(4, 4).g;
  };
  EXPECT_GT(seen(kEarthRadius), 1e-4);
  EXPECT_NEAR(seen(kEarthRadius) / seen(1e8), 1, 1e-3);
}

}  // namespace
