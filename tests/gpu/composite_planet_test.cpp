#include <cmath>

#include "composite_support.hpp"

namespace {

using support::SyntheticScene;

class CompositePlanetTest : public support::GpuTest {};

/// Water that lies an angle ahead around the planet is lit and seen like water underfoot by who looks that much up.
TEST_F(CompositePlanetTest, VerticalsTurnAroundThePlanet) {
  constexpr double kAhead = 0.8;  // [rad]
  const auto sceneFor = [&](double ahead) {
    SyntheticScene scene(gpu(), {61, 45});
    scene.planetRadius = 2e5;
    scene.camera.rotation = support::lookAlong(0, 0.6 + ahead);
    scene.fillWater(20);
    const glm::vec2 place(0, -2e5 * std::sin(ahead));
    std::fill(scene.position.begin(), scene.position.end(), place);
    // A low sun ahead over rough water, so that its glitter shows where it stands.
    const double height = 0.7 - ahead;
    scene.light.sunDirection = glm::vec4(glm::dvec4(0, std::sin(height), -std::cos(height), 1 - 1e-5));
    scene.light.sunIrradiance = glm::vec4(1);
    scene.light.sunRadiance = glm::vec4(1e4f);
    scene.moments = {0.01f, 0.01f, 0, 0};
    scene.render(device());
    return scene;
  };
  const SyntheticScene here = sceneFor(0);
  const SyntheticScene there = sceneFor(kAhead);
  for (std::size_t i = 0; i < here.radiance.size(); ++i) {
    ASSERT_NEAR(there.radiance[i] / here.radiance[i], 1, 0.002) << "pixel " << i / 4;
  }
}

TEST_F(CompositePlanetTest, SkyAndWaterOfDifferentPlanetsAreRefused) {
  const auto output =
      common::createImage(gpu(), vk::Format::eR16G16B16A16Sfloat, {16, 16}, vk::ImageUsageFlagBits::eStorage, "output");
  pelagic::CompositeTargets targets;
  targets.output = output.host(common::kUndefined, common::kTransferSource);
  pelagic::WaterBuffer water;
  water.depth.extent = {16, 16};
  auto composite = pelagic::Composite::create(device());
  ASSERT_TRUE(composite) << composite.error().message;
  const auto sky = pelagic::Sky::create(device(), {}, 2e5);
  ASSERT_TRUE(sky) << sky.error().message;
  const auto eye = pelagic::SkyView::create(*sky, {16, 16});
  ASSERT_TRUE(eye) << eye.error().message;
  for (const pelagic::SkyMaps& maps : {sky->maps(), eye->maps()}) {
    EXPECT_EQ(maps.planetRadius, 2e5);
    const auto view = pelagic::CompositeView::create(*composite, {}, maps, water, targets);
    ASSERT_FALSE(view);
    EXPECT_EQ(view.error().code, pelagic::ErrorCode::invalidArgument);
    EXPECT_EQ(view.error().message, "SkyMaps::planetRadius is 200000, it must be WaterBuffer's, 6.371e+06 m");
  }
}

}  // namespace
