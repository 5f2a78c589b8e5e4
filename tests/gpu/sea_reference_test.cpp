/// Radiance of the sea as it is shaded, against rays traced through an explicit surface under the same sky.
#include <cmath>
#include <cstring>
#include <numbers>

#include "composite_support.hpp"
#include "physics/atmosphere.glsl"
#include "physics/optics.glsl"
#include "support/reference_tracer.hpp"

namespace {

using namespace pelagic;
using support::FacetedSea;
using support::SeaLighting;
using support::SeaRadiance;
using support::SyntheticScene;

struct View {
  const char* name;
  double zenith;   ///< Of the direction toward the viewer [degrees].
  double azimuth;  ///< From the sun's [degrees].
};
constexpr double kSunElevation = 0.6;
/// The wind blows away from the sun, so that these look along it, across it and between.
constexpr View kViews[] = {{"30 toward the sun", 30, 180}, {"30 across", 30, 90}, {"60 from the sun", 60, 0},
                           {"80 between", 80, 120},        {"87 across", 87, 90}, {"glitter", 55.6, 180}};

class SeaReferenceTest : public support::GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    SkyState state;
    state.sunElevation = kSunElevation;
    sky_.emplace(Sky::create(device(), state).value());
    gpu().run([&](vk::CommandBuffer commands) { sky_->record(commands, 0); });
    radiance_ = common::readFloats(gpu(), sky_->maps().radiance);
    const auto bytes = common::readBuffer(gpu(), sky_->maps().light, sky_->maps().lightSize);
    std::memcpy(&light_, bytes.data(), sizeof(light_));
  }
  void TearDown() override {
    sky_.reset();
    GpuTest::TearDown();
  }
  /// Bilinear, above the horizon.
  glm::dvec3 skyToward(const glm::dvec3& d) const {
    const VkExtent2D extent = sky_->maps().radiance.extent;
    const glm::dvec2 uv(shader::skyUv(glm::vec3(d)));
    const double x = uv.x * extent.width - 0.5;
    const double y = std::clamp(uv.y * extent.height - 0.5, 0.5 * extent.height, extent.height - 1.001);
    const glm::dvec2 low(std::floor(x), std::floor(y));
    const auto texel = [&](double dx, double dy) {
      const auto column = static_cast<std::uint32_t>(low.x + dx + extent.width) % extent.width;
      const float* p = &radiance_[4 * (static_cast<std::uint32_t>(low.y + dy) * std::size_t{extent.width} + column)];
      return glm::dvec3(p[0], p[1], p[2]);
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), x - low.x), glm::mix(texel(0, 1), texel(1, 1), x - low.x),
                    y - low.y);
  }
  SeaLighting lighting(const WaterMedium& medium) const {
    SeaLighting lighting;
    lighting.sky = [this](const glm::dvec3& d) { return skyToward(d); };
    lighting.sunDirection = glm::dvec3(light_.sunDirection);
    lighting.sunIrradiance = glm::dvec3(light_.sunIrradiance);
    lighting.sunRadius = 0.05;  // ten times the sun's: a hundred times the rays meet it, and waves blur it more
    const glm::vec3 entering = physics::enteringIrradiance(glm::vec3(light_.sunIrradiance), light_.sunDirection.y,
                                                           glm::vec3(light_.skyIrradiance));
    const glm::vec3 reflectance = physics::deepReflectance(medium.absorption, medium.backscatter);
    lighting.waterRadiance = glm::dvec3(entering * physics::waterLeaving(reflectance));
    return lighting;
  }
  /// As the composite shades a pixel that resolves none of the waves.
  SeaRadiance shaded(const glm::dvec3& covariance, const glm::dvec3& v) {
    SyntheticScene scene(gpu(), {8, 8});
    scene.realSky = &*sky_;
    scene.camera.projection = support::perspective(1e-3, 1, 0.1, true);
    scene.camera.rotation = support::lookAlong(std::atan2(-v.x, v.z), std::asin(v.y));
    scene.fillWater(10);
    scene.withOutputs = false;
    scene.waves.unresolved = {covariance.x, covariance.y};
    const auto render = [&](bool sun, bool water) {
      scene.light = light_;
      scene.light.rayleighExtinction = glm::vec4(0, 0, 0, 8000);
      scene.light.mieExtinction = glm::vec4(0, 0, 0, 1200);
      if (!sun) scene.light.sunIrradiance = glm::vec4(0);
      scene.medium.backscatter = water ? WaterMedium().backscatter : glm::vec3(0);
      scene.render(device());
      return glm::dvec3(scene.radianceAt(4, 4));
    };
    const glm::dvec3 all = render(true, true), above = render(true, false), sky = render(false, false);
    return {sky, above - sky, all - above};
  }

  std::optional<Sky> sky_;
  std::vector<float> radiance_;
  shader::SkyLight light_{};
};

double meanOf(const glm::dvec3& c) { return (c.x + c.y + c.z) / 3; }

/// Of `seas` under the light, mean of all.
SeaRadiance traced(const std::vector<FacetedSea>& seas, const SeaLighting& light, const glm::dvec3& v) {
  SeaRadiance mean;
  for (const FacetedSea& sea : seas) {
    // Steep rays are short, and few of them meet the sun.
    const SeaRadiance one = traceSea(sea, light, v, v.y > 0.3 ? 200000 : 30000);
    const double share = 1.0 / static_cast<double>(seas.size());
    mean.sky += share * one.sky;
    mean.sun += share * one.sun;
    mean.water += share * one.water;
  }
  return mean;
}

TEST_F(SeaReferenceTest, SixViewsAgreeWithTracedRays) {
  constexpr double kWind = 7;
  std::vector<FacetedSea> seas;
  glm::dvec3 covariance(0);
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    seas.emplace_back(1024, 0.00316 * kWind, 0.003 + 0.00192 * kWind, seed);
    covariance += 0.25 * seas.back().slopeCovariance();
  }
  const SeaLighting light = lighting({});
  double mean = 0;
  for (const View& view : kViews) {
    const double zenith = view.zenith * std::numbers::pi / 180, azimuth = view.azimuth * std::numbers::pi / 180;
    const glm::dvec3 v(std::sin(zenith) * std::cos(azimuth), std::cos(zenith), std::sin(zenith) * std::sin(azimuth));
    const SeaRadiance expected = traced(seas, light, v);
    const SeaRadiance got = shaded(covariance, v);
    const double error = meanOf(glm::abs(got.sum() / expected.sum() - 1.0));
    mean += error / std::size(kViews);
    EXPECT_LT(error, 0.06) << view.name;
    // Each part's error, relative to the whole.
    const auto part = [&](const glm::dvec3& a, const glm::dvec3& b) { return meanOf(a - b) / meanOf(expected.sum()); };
    EXPECT_NEAR(part(got.sky, expected.sky), 0, 0.07) << view.name;
    EXPECT_NEAR(part(got.sun, expected.sun), 0, 0.05) << view.name;
    EXPECT_NEAR(part(got.water, expected.water), 0, 0.01) << view.name;
    RecordProperty(view.name, std::to_string(error));
  }
  EXPECT_LT(mean, 0.03);
  RecordProperty("mean", std::to_string(mean));
}

}  // namespace
