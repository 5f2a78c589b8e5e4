#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <pelagic/sky.hpp>

#include "composite_support.hpp"
#include "pelagic/shader/sky_light.h"
#include "physics/moon.glsl"

namespace {

namespace physics = pelagic::physics;
constexpr double kPi = std::numbers::pi;

class NightTest : public support::GpuTest {
 protected:
  struct Night {
    std::vector<float> radiance;
    pelagic::shader::SkyLight light;
  };
  Night draw(const pelagic::SkyState& state) {
    auto sky = pelagic::Sky::create(device(), state);
    if (!sky) throw std::runtime_error(sky.error().message);
    gpu().run([&](vk::CommandBuffer commands) { sky->record(commands, 0); });
    Night night;
    night.radiance = common::readFloats(gpu(), sky->maps().radiance, 0);
    const auto bytes = common::readBuffer(gpu(), sky->maps().light, sky->maps().lightSize);
    std::memcpy(&night.light, bytes.data(), sizeof(night.light));
    return night;
  }
};

/// Scattering is linear: where the moon stands, all light is that of a sun there, as much weaker as the moon is.
TEST_F(NightTest, MoonlightIsSunlightButWeaker) {
  pelagic::SkyState day, night;
  day.sunElevation = 0.6;
  day.sunAzimuth = 2.5;
  night.sunElevation = -0.5;
  night.sunAzimuth = 1;
  night.moonElevation = day.sunElevation;
  night.moonAzimuth = day.sunAzimuth;
  night.moonIlluminated = 0.5;
  const Night sun = draw(day), moon = draw(night);
  const glm::dvec3 strength = glm::dvec3(physics::kMoonTint) * static_cast<double>(physics::moonStrength(0.5f)) *
                              pelagic::twilightGain(night.sunElevation);
  for (int c = 0; c < 3; ++c) {
    const auto of = [&](const glm::vec4& value) { return static_cast<double>(value[c]); };
    EXPECT_NEAR(of(moon.light.sunIrradiance) / of(sun.light.sunIrradiance) / strength[c], 1, 2e-3);
    EXPECT_EQ(moon.light.sunDirection[c], sun.light.sunDirection[c]);
    for (const std::size_t texel : {200u * 512u + 40u, 150u * 512u + 300u, 250u * 512u + 500u}) {
      const std::size_t at = 4 * texel + static_cast<std::size_t>(c);
      const double dark = 1.3e-9 * pelagic::twilightGain(night.sunElevation);
      EXPECT_NEAR((moon.radiance[at] - dark) / sun.radiance[at] / strength[c], 1, 0.01) << texel << ' ' << c;
    }
  }
  EXPECT_EQ(moon.light.sunRadiance.w, 0);
  EXPECT_EQ(sun.light.sunRadiance.w, 1);
}

TEST_F(NightTest, TheMoonTakesOverTwoDegreesAfterSunset) {
  pelagic::SkyState state;
  state.moonElevation = 0.4;
  state.moonAzimuth = 1;
  state.sunElevation = -0.03;
  EXPECT_EQ(draw(state).light.sunRadiance.w, 1);
  state.sunElevation = -0.04;
  EXPECT_EQ(draw(state).light.sunRadiance.w, 0);
  state.moonElevation = -0.1;
  const auto moonless = draw(state).light;
  EXPECT_EQ(moonless.sunRadiance.w, 1);
  EXPECT_EQ(moonless.moonRadiance, glm::vec4(0));
}

/// A half moon's lit side is the one toward the sun.
TEST_F(NightTest, TheDiscIsLitFromTheSun) {
  support::SyntheticScene scene(gpu(), {64, 64});
  scene.sky = {0, 0, 0, 1};
  scene.camera.rotation = support::lookAlong(0, 0);
  scene.camera.projection = support::perspective(0.02, 1, 0.1, true);
  scene.light.moonDirection = glm::vec4(0, 0, -1, 0);
  scene.light.moonRadiance = glm::vec4(3, 3, 3, 0);
  scene.light.moonLit = glm::vec4(1, 0, 0, 0);  // to the right
  scene.withOutputs = false;
  scene.render(device());
  double left = 0, right = 0;
  const double pixel = std::pow(2 * std::tan(0.01) / 64, 2);
  for (std::uint32_t y = 0; y < 64; ++y) {
    for (std::uint32_t x = 0; x < 64; ++x) (x < 32 ? left : right) += scene.radianceAt(x, y).x * pixel;
  }
  const double half = 3 * kPi / 2 * std::pow(pelagic::kSunAngularRadius, 2);
  EXPECT_NEAR(right / half, 1, 0.06);
  EXPECT_LT(left, 0.06 * half);
  // A crescent, 17 degrees from the sun, is a bright line along the limb.
  scene.light.moonLit = glm::vec4(std::sin(0.3f), 0, -std::cos(0.3f), 0);
  scene.render(device());
  float brightest = 0;
  for (std::uint32_t x = 32; x < 64; ++x) brightest = std::max(brightest, scene.radianceAt(x, 32).x);
  EXPECT_GT(brightest, 1.5f);
  EXPECT_LT(scene.radianceAt(32, 32).x, 0.01f);
}

/// All starlight over the sphere is what the magnitudes add up to; and it turns with the sky.
TEST_F(NightTest, StarsCarryTheirIrradiance) {
  const auto draw = [&](double yaw, double pitch, const glm::vec4& turn) {
    support::SyntheticScene scene(gpu(), {640, 640});
    scene.sky = {0, 0, 0, 1};
    scene.camera.rotation = support::lookAlong(yaw, pitch);
    scene.camera.projection = support::perspective(kPi / 2, 1, 0.1, true);
    scene.light.skyIrradiance = glm::vec4(0, 0, 0, 1e6);
    scene.light.stars = turn;
    scene.light.moonDirection.w = 1;
    scene.withOutputs = false;
    scene.render(device());
    return scene.radiance;
  };
  constexpr int kCount = 98304;
  double expected = 0;
  for (int i = 0; i < kCount; ++i) {
    const float u = (static_cast<float>(i) + 0.5f) / kCount;
    expected += 1e6 * static_cast<double>(physics::starStrength(physics::starMagnitude(u, kCount)));
  }
  // Six faces of a cube are the sphere.
  double sum = 0;
  std::size_t dark = 0;
  for (int face = 0; face < 6; ++face) {
    const double pitch = face == 4 ? kPi / 2 : face == 5 ? -kPi / 2 : 0;
    const std::vector<float> picture = draw(face * kPi / 2, pitch, {0, 0, 0, 1});
    for (std::size_t i = 0; i < picture.size() / 4; ++i) {
      const double x = (static_cast<double>(i % 640) + 0.5) / 320 - 1,
                   y = (static_cast<double>(i / 640) + 0.5) / 320 - 1;
      sum += static_cast<double>(picture[4 * i + 1]) / std::pow(1 + x * x + y * y, 1.5) / (320 * 320);
      dark += picture[4 * i + 1] == 0;
    }
  }
  EXPECT_NEAR(sum / expected, 1, 0.25) << "the few brightest are chance";
  EXPECT_GT(dark, 6u * 640 * 640 / 2) << "points, not a glow";
  // A quarter turn about the vertical: what stood ahead stands to the side.
  const double c = std::sqrt(0.5);
  const std::vector<float> ahead = draw(0, 0, {0, 0, 0, 1}), turned = draw(kPi / 2, 0, {0, c, 0, c});
  for (std::size_t i = 0; i < ahead.size(); i += 401) EXPECT_NEAR(ahead[i], turned[i], 1e-3 + 0.2 * ahead[i]) << i;
}

}  // namespace
