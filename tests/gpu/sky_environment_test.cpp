#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <numbers>
#include <pelagic/sky.hpp>

#include "composite_support.hpp"
#include "sky_fixture.hpp"

namespace {

using namespace pelagic;
constexpr double kPi = std::numbers::pi;

/// L(azimuth, elevation) [rad].
using Radiance = std::function<glm::dvec3(double, double)>;

SkyEnvironment pictureOf(const Radiance& radiance, std::uint32_t width = 256) {
  SkyEnvironment picture;
  picture.width = width;
  picture.height = width / 2;
  for (std::uint32_t j = 0; j < picture.height; ++j) {
    for (std::uint32_t i = 0; i < width; ++i) {
      picture.radiance.emplace_back(radiance(2 * kPi * (i + 0.5) / width, kPi / 2 - kPi * (j + 0.5) / picture.height));
    }
  }
  return picture;
}

glm::dvec3 toward(double azimuth, double elevation) {
  return {std::cos(elevation) * std::cos(azimuth), std::sin(elevation), std::cos(elevation) * std::sin(azimuth)};
}

/// 1 within `radius` of a direction, else 0.
double disc(const glm::dvec3& centre, double radius, double azimuth, double elevation) {
  return glm::dot(centre, toward(azimuth, elevation)) > std::cos(radius) ? 1 : 0;
}

/// Irradiance on the horizontal of a picture's upper half, by the exact projected solid angles of its pixels.
glm::dvec3 irradianceOf(const SkyEnvironment& picture) {
  glm::dvec3 sum(0);
  const auto square = [&](std::uint32_t j) { return std::pow(std::cos(kPi * j / picture.height), 2); };
  for (std::uint32_t j = 0; j < picture.height / 2; ++j) {
    for (std::uint32_t i = 0; i < picture.width; ++i) {
      sum += 0.5 * (square(j) - square(j + 1)) * 2 * kPi / picture.width *
             glm::dvec3(picture.radiance[std::size_t{j} * picture.width + i]);
    }
  }
  return picture.scale * sum;
}

using Map = support::SkyMap;

class SkyEnvironmentTest : public support::SkyFixture {
 protected:
  struct Picture {
    Map radiance, environment, view;
    shader::SkyLight light, viewLight;
  };
  Sky create(const SkyEnvironment& environment, const SkyState& state = {}) {
    return createSky(state, kEarthRadius, environment);
  }
  Picture draw(Sky& sky, SkyView& view, double altitude = 5) {
    gpu().run([&](vk::CommandBuffer commands) {
      sky.record(commands, 0);
      view.record(commands, cameraAt(altitude));
    });
    return {read(sky.maps().radiance), read(sky.maps().environment), read(view.maps().radiance), light(sky.maps()),
            light(view.maps())};
  }
  Picture draw(Sky& sky, double altitude = 5) {
    SkyView view = createView(sky);
    return draw(sky, view, altitude);
  }
};

TEST_F(SkyEnvironmentTest, IrradianceHasItsClosedForms) {
  Sky sky = create(pictureOf([](double, double) { return glm::dvec3(0.5, 1, 2); }));
  const Picture even = draw(sky);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(even.light.skyIrradiance[c], kPi * std::exp2(c - 1), 1e-4 * kPi);
  EXPECT_EQ(even.light.skyIrradiance.w, 1);
  EXPECT_EQ(glm::length(glm::vec3(even.light.sunIrradiance)), 0);
  for (const int y : {0, 100, 128, 200, 255}) {
    for (const int x : {0, 255, 511}) EXPECT_EQ(even.radiance.at(x, y), glm::dvec3(0.5, 1, 2)) << x << ' ' << y;
  }
  // L = sin^n(e) gives 2 pi/(n + 2).
  for (const int n : {1, 2, 5}) {
    SkyEnvironment lobe =
        pictureOf([n](double, double e) { return glm::dvec3(std::pow(std::max(std::sin(e), 0.0), n)); });
    lobe.scale = 3;
    ASSERT_TRUE(sky.setEnvironment(lobe));
    const Picture drawn = draw(sky);
    EXPECT_NEAR(drawn.light.skyIrradiance.g, 3 * 2 * kPi / (n + 2), 1e-3) << n;
    EXPECT_EQ(drawn.viewLight.skyIrradiance.g, drawn.light.skyIrradiance.g);
  }
}

TEST_F(SkyEnvironmentTest, BelowTheHorizonThePictureIsIgnored) {
  const auto half = [](double below) {
    return pictureOf([below](double a, double e) { return glm::dvec3(e < 0 ? below : 1.5 + std::sin(a)); });
  };
  Sky sky = create(half(0));
  const Picture dark = draw(sky);
  ASSERT_TRUE(sky.setEnvironment(half(1e6)));
  const Picture bright = draw(sky);
  EXPECT_EQ(dark.radiance.texels, bright.radiance.texels);
  EXPECT_EQ(dark.environment.texels, bright.environment.texels);
  EXPECT_EQ(dark.light.skyIrradiance, bright.light.skyIrradiance);
  // The air there has the light of the horizon.
  for (const double azimuth : {0.3, 2.0, 4.5}) {
    const int x = static_cast<int>(azimuth / (2 * kPi) * dark.view.width);
    EXPECT_NEAR(dark.view.at(x, 20).g, 1.5 + std::sin(azimuth), 0.02) << azimuth;
  }
}

TEST_F(SkyEnvironmentTest, WhatIsBrightStandsWhereItIs) {
  const double azimuth = 1.0, elevation = 0.5, turn = 0.7;
  SkyEnvironment picture = pictureOf(
      [&](double a, double e) { return glm::dvec3(0.1 + disc(toward(azimuth, elevation), 0.15, a, e)); }, 1024);
  for (const double rotation : {0.0, turn, turn - 8 * kPi}) {
    picture.rotation = rotation;
    Sky sky = create(picture);
    const Picture drawn = draw(sky, 3000);
    EXPECT_EQ(glm::length(glm::vec3(drawn.light.sunIrradiance)), 0) << "a lamp of 17 degrees is no sun";
    EXPECT_EQ(drawn.view.width, 1024);
    const double there = azimuth + rotation;
    for (const Map* map : {&drawn.radiance, &drawn.view}) {
      EXPECT_NEAR(map->toward(there, elevation).g, 1.1, 2e-3);
      // Within two texels of its edges.
      EXPECT_NEAR(map->toward(there, elevation + 0.12).g, 1.1, 2e-3);
      EXPECT_NEAR(map->toward(there, elevation - 0.18).g, 0.1, 2e-3);
      EXPECT_NEAR(map->toward(there + 0.14, elevation).g, 1.1, 2e-3);
      EXPECT_NEAR(map->toward(there + 0.21, elevation).g, 0.1, 2e-3);
      EXPECT_NEAR(map->toward(-there, elevation).g, 0.1, 2e-3);
      EXPECT_NEAR(map->toward(kPi - there, elevation).g, 0.1, 2e-3);
      EXPECT_NEAR(map->toward(kPi / 2 - there, elevation).g, 0.1, 2e-3);
    }
    const glm::dvec3 d = toward(there, elevation);
    const glm::dvec2 uv = 0.5 + 0.5 * 0.8 * glm::dvec2(d.x, d.z) / (1 + d.y);
    EXPECT_NEAR(drawn.environment.at(static_cast<int>(256 * uv.x), static_cast<int>(256 * uv.y)).g, 1.1, 2e-3);
  }
}

TEST_F(SkyEnvironmentTest, TheSeaMirrorsItBelowItsPlace) {
  const double azimuth = 1.0, turn = 0.6, elevation = 0.5;
  SkyEnvironment picture =
      pictureOf([&](double a, double e) { return glm::dvec3(disc(toward(azimuth, elevation), 0.15, a, e)); });
  picture.rotation = turn;
  Sky sky = create(picture);
  draw(sky);
  support::SyntheticScene scene(gpu(), {81, 81});
  scene.realSky = &sky;
  scene.light.skyIrradiance = glm::vec4(0);
  scene.medium.backscatter = glm::vec3(0);
  // lookAlong() turns from -z to +x: the azimuth is less by a right angle.
  scene.camera.rotation = support::lookAlong(azimuth + turn + kPi / 2, elevation);
  scene.fillWater(20);
  scene.render(device());
  glm::dvec3 sum(0);
  for (std::uint32_t y = 0; y < 81; ++y) {
    for (std::uint32_t x = 0; x < 81; ++x) {
      const glm::dvec3 d = scene.directionAt(x, y);
      sum += static_cast<double>(scene.radianceAt(x, y).g) * glm::dvec3(d.x, -d.y, d.z);
    }
  }
  ASSERT_GT(glm::length(sum), 0.1);
  // Fresnel draws the middle a little down.
  EXPECT_LT(glm::distance(glm::normalize(sum), toward(azimuth + turn, elevation)), 0.03);
}

TEST_F(SkyEnvironmentTest, TheSunIsTakenOutAndNoLightIsLost) {
  for (const auto& [azimuth, elevation] : {std::pair{2.1, 0.6}, {4.0, 1.5}, {0.01, 0.06}}) {
    SkyEnvironment picture = pictureOf(
        [&, azimuth = azimuth, elevation = elevation](double a, double e) {
          const double sky = 1 + 0.5 * std::sin(a) * std::cos(e);
          return sky * glm::dvec3(0.6, 0.8, 1) +
                 glm::dvec3(9e3, 8e3, 6e3) * disc(toward(azimuth, elevation), 0.01, a, e);
        },
        1024);
    picture.rotation = -0.4;
    picture.scale = 0.25;
    Sky sky = create(picture);
    const Picture drawn = draw(sky);
    const auto& light = drawn.light;
    const glm::dvec3 total = irradianceOf(picture);
    const glm::dvec3 found =
        glm::dvec3(light.skyIrradiance) + static_cast<double>(light.sunDirection.y) * glm::dvec3(light.sunIrradiance);
    EXPECT_LT(glm::length(found - total), 1e-4 * glm::length(total)) << elevation;
    EXPECT_GT(light.sunIrradiance.g, 0.25 * 8e3 * kPi * 1e-4 * 0.7);
    EXPECT_GT(light.sunIrradiance.r, 1.3f * light.sunIrradiance.b);
    EXPECT_LT(glm::distance(glm::dvec3(light.sunDirection), toward(azimuth - 0.4, elevation)), 0.003);
    EXPECT_NEAR(light.sunRadiance.g * kPi * std::pow(kSunAngularRadius, 2) / light.sunIrradiance.g, 1, 1e-3);
    EXPECT_EQ(light.sunRadiance.w, 1) << "the disc is drawn";
    // It is gone from the maps.
    for (const Map* map : {&drawn.radiance, &drawn.view, &drawn.environment}) {
      EXPECT_LT(*std::max_element(map->texels.begin(), map->texels.end()), 1.01);
    }
  }
}

TEST_F(SkyEnvironmentTest, WhatHardlyStandsOutIsNoSun) {
  const SkyEnvironment picture =
      pictureOf([](double a, double e) { return glm::dvec3(1 + 2.5 * disc(toward(1, 0.7), 0.05, a, e)); }, 1024);
  Sky sky = create(picture);
  const auto light = draw(sky).light;
  EXPECT_EQ(glm::length(glm::vec3(light.sunIrradiance)), 0);
  EXPECT_NEAR(light.skyIrradiance.g, irradianceOf(picture).g, 1e-4);
}

TEST_F(SkyEnvironmentTest, AGivenSunIsBesideThePicture) {
  SkyEnvironment picture =
      pictureOf([](double a, double e) { return glm::dvec3(1 + 5e3 * disc(toward(1, 0.7), 0.03, a, e)); });
  picture.rotation = 2;
  picture.sun = EnvironmentSun{0.3, 2.5, {4, 5, 6}};
  Sky sky = create(picture);
  const auto light = draw(sky).light;
  EXPECT_EQ(glm::vec3(light.sunIrradiance), glm::vec3(4, 5, 6));
  EXPECT_LT(glm::distance(glm::dvec3(light.sunDirection), toward(2.5, 0.3)), 1e-6);
  EXPECT_NEAR(light.skyIrradiance.g, irradianceOf(picture).g, 1e-4 * irradianceOf(picture).g);
}

TEST_F(SkyEnvironmentTest, OfTheStateTheHazeAndItsHeightAloneCount) {
  SkyState state;
  state.clouds.cover = 0.6;
  state.overcast = 0.3;
  Sky sky = create(pictureOf([](double a, double) { return glm::dvec3(1.5 + std::cos(a)); }), state);
  auto view = createView(sky);
  const Picture first = draw(sky, view);
  state.sunElevation = -0.4;
  state.moonElevation = 0.5;
  state.haze = 3;
  state.hazeHeight = 400;
  ASSERT_TRUE(sky.setState(state));
  const Picture second = draw(sky, view, 4000);
  EXPECT_EQ(first.view.texels, second.view.texels);
  EXPECT_EQ(first.light.skyIrradiance, second.light.skyIrradiance);
  EXPECT_NEAR(second.viewLight.mieExtinction.g / 3, 5.86e-5, 1e-9);
  EXPECT_EQ(second.viewLight.mieExtinction.w, 400);
  const Map clouds = read(view.maps().clouds);
  for (std::size_t i = 0; i < clouds.texels.size(); ++i) EXPECT_EQ(clouds.texels[i], i % 4 == 3 ? 1 : 0);
}

TEST_F(SkyEnvironmentTest, PelagicsOwnSkyComesBack) {
  SkyState state;
  state.clouds.cover = 0.4;
  Sky own = create({}, state);
  auto ownView = createView(own);
  const Picture expected = draw(own, ownView, 800);
  const SkyEnvironment even = pictureOf([](double, double) { return glm::dvec3(0.5); }, 64);
  Sky sky = create(even, state);
  auto view = createView(sky);
  for (int round = 0; round < 2; ++round) {
    ASSERT_TRUE(sky.setEnvironment(even));
    EXPECT_NEAR(draw(sky, view, 800).view.at(9, 200).g, 0.5, 1e-3);
    ASSERT_TRUE(sky.setEnvironment({}));
    const Picture back = draw(sky, view, 800);
    EXPECT_EQ(back.radiance.texels, expected.radiance.texels);
    EXPECT_EQ(back.view.texels, expected.view.texels);
    EXPECT_EQ(back.environment.texels, expected.environment.texels);
    EXPECT_EQ(0, std::memcmp(&back.viewLight, &expected.viewLight, sizeof(back.viewLight)));
    EXPECT_EQ(read(view.maps().clouds).texels, read(ownView.maps().clouds).texels);
  }
}

/// Also where it was set between the two: then the maps of what is set have never been written.
TEST_F(SkyEnvironmentTest, ViewsFollowWhatWasRecordedLast) {
  const SkyEnvironment even = pictureOf([](double, double) { return glm::dvec3(0.5); }, 64);
  Sky sky = create(even);
  auto view = createView(sky);
  draw(sky, view, 5);
  ASSERT_TRUE(sky.setEnvironment({}));
  gpu().run([&](vk::CommandBuffer commands) { view.record(commands, cameraAt(4000)); });
  EXPECT_NEAR(read(view.maps().radiance).at(9, 200).g, 0.5, 1e-3);
  const glm::dvec3 own = draw(sky, view, 4000).view.at(9, 200);
  EXPECT_GT(std::abs(own.g - 0.5), 0.1);
  ASSERT_TRUE(sky.setEnvironment(even));
  gpu().run([&](vk::CommandBuffer commands) { view.record(commands, cameraAt(4001)); });
  EXPECT_NEAR(read(view.maps().radiance).at(9, 200).g, own.g, 1e-3);
}

TEST_F(SkyEnvironmentTest, ErrorsNameFieldValueAndRange) {
  const SkyEnvironment good = pictureOf([](double, double) { return glm::dvec3(1); }, 64);
  Sky sky = create(good);
  const auto refused = [&](const std::function<void(SkyEnvironment&)>& change, const std::string& sentence) {
    SkyEnvironment bad = good;
    change(bad);
    const auto set = sky.setEnvironment(bad);
    ASSERT_FALSE(set) << sentence;
    EXPECT_EQ(set.error().code, ErrorCode::invalidArgument);
    EXPECT_EQ(set.error().message, "SkyEnvironment::" + sentence);
  };
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  refused([&](auto& p) { p.radiance[7].g = nan; },
          "radiance[7] is (1, nan, 1), it must lie in 0 … 1e9 in each channel");
  refused([&](auto& p) { p.radiance[2047].b = infinite; },
          "radiance[2047] is (1, 1, inf), it must lie in 0 … 1e9 in each channel");
  refused([](auto& p) { p.radiance[0].r = -0.5f; },
          "radiance[0] is (-0.5, 1, 1), it must lie in 0 … 1e9 in each channel");
  refused([](auto& p) { p.radiance.pop_back(); }, "radiance.size() is 2047, it must be width x height, 2048");
  refused([](auto& p) { p.height = 33; }, "height is 33, it must be half of width, 32");
  refused([](auto& p) { p.width = 66; }, "width is 66, it must be a multiple of 4 in 4 … 4096, or 0 for no picture");
  refused([](auto& p) { p.width = 8192; },
          "width is 8192, it must be a multiple of 4 in 4 … 4096, or 0 for no picture");
  refused([](auto& p) { p.width = 0; }, "width is 0, it must lie in 4 … 4096 where there is a picture");
  refused([&](auto& p) { p = pictureOf([](double, double) { return glm::dvec3(1); }, 32); },
          "width is 32, it must be 64 as at create(), or 0");
  refused([&](auto& p) { p.scale = -1; }, "scale is -1, it must be 0 to 1e6");
  refused([&](auto& p) { p.rotation = nan; }, "rotation is nan, it must be finite");
  refused([](auto& p) { p.sun = EnvironmentSun{-0.1, 0, {}}; }, "sun.elevation is -0.1, it must be 0 to pi/2");
  refused([&](auto& p) { p.sun = EnvironmentSun{0.1, nan, {}}; }, "sun.azimuth is nan, it must be finite");
  refused(
      [](auto& p) {
        p.sun = EnvironmentSun{0.1, 0, {0, -1, 0}};
      },
      "sun.irradiance is (0, -1, 0), it must lie in 0 … 1e9 in each channel");
  Sky own = create({});
  const auto set = own.setEnvironment(good);
  ASSERT_FALSE(set);
  EXPECT_EQ(set.error().message, "SkyEnvironment::width is 64, it must be 0: Sky::create() was given no picture");
  EXPECT_FALSE(Sky::create(device(), {}, kEarthRadius, {4, 2, {}, 1, 0, {}}));
}

}  // namespace
