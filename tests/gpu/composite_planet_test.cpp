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

}  // namespace
