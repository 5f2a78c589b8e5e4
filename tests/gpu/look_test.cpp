#include <cmath>
#include <memory>
#include <numbers>
#include <set>

#include "composite_support.hpp"
#include "physics/optics.glsl"

namespace {

using namespace pelagic;
using support::SyntheticScene;

/// A flat sea under an even sky without a sun, whose radiance has a closed form.
class LookTest : public support::GpuTest {
 protected:
  void SetUp() override {
    support::GpuTest::SetUp();
    scene_ = std::make_unique<SyntheticScene>(gpu(), vk::Extent2D{61, 45});
    scene_->fillWater(20);
  }

  /// Compares every ninth pixel's channels with F sky contrast + (1 - F) body(direction toward the eye, channel).
  template <class Body>
  void expectBody(double contrast, const Body& body) {
    scene_->render(device());
    for (std::uint32_t y = 2; y < 45; y += 6) {
      for (std::uint32_t x = 1; x < 61; x += 9) {
        const glm::dvec3 v = -scene_->directionAt(x, y);
        const double share = physics::fresnelReflectance(static_cast<float>(v.y), physics::kWaterIndex);
        for (int i = 0; i < 3; ++i) {
          const double expected = share * contrast * sky(i) + (1 - share) * body(v, i);
          EXPECT_NEAR(scene_->radianceAt(x, y)[i] / expected, 1, 0.01) << x << ' ' << y << ' ' << i;
        }
      }
    }
  }
  /// What a white surface below the water would send up, times `colour`.
  double shown(double colour, int channel) const { return colour / std::numbers::pi * entering(channel); }
  double sky(int channel) const { return scene_->sky[static_cast<std::size_t>(channel)]; }
  /// Irradiance of the even sky that enters the water.
  double entering(int channel) const { return std::numbers::pi * sky(channel) * (1 - physics::kDiffuseReflectance); }

  std::unique_ptr<SyntheticScene> scene_;
};

TEST_F(LookTest, DeepAndShallowMixByShallowness) {
  WaterLook& look = scene_->medium.look;
  look.law = WaterLook::Law::deepShallow;
  look.deep = {0.1f, 0.2f, 0.3f};
  look.shallow = {0.5f, 0.4f, 0.9f};
  look.shallowness = 0.25f;
  expectBody(1, [&](const glm::dvec3&, int i) { return shown(0.75 * look.deep[i] + 0.25 * look.shallow[i], i); });
}

TEST_F(LookTest, ColourGoesByTheAngleOfView) {
  WaterLook& look = scene_->medium.look;
  look.law = WaterLook::Law::viewAngle;
  look.deep = {0.1f, 0.2f, 0.3f};
  look.shallow = {0.8f, 0.4f, 0.1f};
  look.contrast = 2.5f;
  expectBody(2.5, [&](const glm::dvec3& v, int i) {
    const double angle = std::acos(v.y) / (std::numbers::pi / 2);
    return shown((1 - angle) * look.deep[i] + angle * look.shallow[i], i);
  });
}

TEST_F(LookTest, ThinCrestsAgainstTheLightAreLessOpaque) {
  WaterLook& look = scene_->medium.look;
  look.law = WaterLook::Law::thickness;
  look.deep = {0.1f, 0.2f, 0.3f};
  look.leastOpacity = 0.1f;
  look.opaqueDepth = 2.4f;  // four times as thick as the thinnest crest, 0.6 m
  const double opacity = 0.1 + 0.9 * 0.5;
  // As sharp as crests get. The sun is where the camera looks, and has no light of its own.
  scene_->gradient = {0, 0, -0.5f, -0.5f};
  const glm::dvec3 ahead = scene_->directionAt(30, 22);
  scene_->light.sunDirection = glm::vec4(glm::normalize(glm::dvec3(ahead.x, 0.2, ahead.z)), 1);
  const glm::dvec3 l(scene_->light.sunDirection);
  expectBody(1, [&](const glm::dvec3& v, int i) {
    const double against = std::max(-(v.x * l.x + v.z * l.z) / std::hypot(v.x, v.z), 0.0);
    return shown(look.deep[i], i) * (1 - against * (1 - opacity)) + 0.35 * against * sky(i) * (1 - opacity);
  });
}

TEST_F(LookTest, NamesAreUniqueAndTheirLooksAllowed) {
  std::set<std::string_view> names;
  for (const auto& [name, look] : waterLooks()) {
    EXPECT_TRUE(names.insert(name).second) << name;
    WaterMedium medium;
    medium.look = look;
    EXPECT_TRUE(validate(medium)) << name;
  }
  EXPECT_EQ(waterLooks().front().look.law, WaterLook::Law::medium);
}

}  // namespace
