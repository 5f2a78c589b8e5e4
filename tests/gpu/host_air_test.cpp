#include <cmath>

#include "composite_support.hpp"

namespace {

using support::SyntheticScene;

class HostAirTest : public support::GpuTest {
 protected:
  /// Nothing but an object of the host, `axial` metres from an eye that looks down by `pitch`, and hazy air.
  SyntheticScene sceneOf(double eye, double pitch, float axial, const std::array<float, 4>& color) {
    SyntheticScene scene(gpu(), {9, 9});
    scene.camera.position = {500, eye, -700};
    scene.camera.rotation = support::lookAlong(0.4, pitch);
    scene.withHost = true;
    scene.hostColor = color;
    std::fill(scene.hostDepth.begin(), scene.hostDepth.end(), scene.depthAt(axial));
    scene.light.rayleighExtinction = glm::vec4(7.1e-6f, 1.4e-5f, 3.3e-5f, 8000);
    scene.light.mieExtinction = glm::vec4(5.5e-5f, 5.9e-5f, 6.4e-5f, 1200);
    return scene;
  }
  /// Where the ray of a pixel ends: its length and the height there over the curved sea [m].
  struct Path {
    double eye, up, length, radius;
    double heightAt(double t) const {
      const double from = radius + eye;
      return std::sqrt(from * from + 2 * from * up * t + t * t) - radius;
    }
  };
  static Path pathOf(const SyntheticScene& scene, float axial) {
    const glm::dvec3 d = scene.directionAt(4, 4), ahead = -glm::transpose(glm::dmat3(scene.camera.rotation))[2];
    return {scene.camera.position.y, d.y, static_cast<double>(axial) / glm::dot(d, ahead), scene.planetRadius};
  }
  /// Transmittance of exponential air by quadrature along the path.
  static double transmittance(const SyntheticScene& scene, const Path& path, int channel) {
    double depth = 0;
    constexpr int kSteps = 4000;
    for (int i = 0; i < kSteps; ++i) {
      const double h = std::max(path.heightAt(path.length * (i + 0.5) / kSteps), 0.0);
      for (const glm::vec4& part : {scene.light.rayleighExtinction, scene.light.mieExtinction}) {
        depth += static_cast<double>(part[channel]) * std::exp(-h / static_cast<double>(part.w)) * path.length / kSteps;
      }
    }
    return std::exp(-depth);
  }
};

TEST_F(HostAirTest, AnObjectIsItsLightTimesTAndTheAirsTimesTheRest) {
  struct Case {
    double eye, pitch;
    float axial;
  };
  for (const Case& c : {Case{3, 0, 500}, Case{3, 0, 10000}, Case{3, 0, 20000}, Case{3, -0.5, 8000},
                        Case{2000, 0.2, 9000}, Case{5000, 0, 20000}, Case{5000, -0.1, 20000}}) {
    for (const std::array<float, 4>& color : {std::array{0.5f, 0.5f, 0.5f, 1.0f}, std::array{0.0f, 0.0f, 0.0f, 1.0f}}) {
      SyntheticScene scene = sceneOf(c.eye, c.pitch, c.axial, color);
      scene.render(device());
      const Path path = pathOf(scene, c.axial);
      for (int i = 0; i < 3; ++i) {
        const double t = transmittance(scene, path, i), air = scene.sky[static_cast<std::size_t>(i)];
        const double expected = t * static_cast<double>(color[static_cast<std::size_t>(i)]) + (1 - t) * air;
        EXPECT_NEAR(scene.radianceAt(4, 4)[i] / expected, 1, 3e-3) << c.eye << ' ' << c.axial << ' ' << i;
      }
    }
  }
}

TEST_F(HostAirTest, NearObjectsAreTheHosts) {
  SyntheticScene scene = sceneOf(3, 0.1, 10, {0.5f, 0.5f, 0.5f, 1});
  scene.render(device());
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(scene.radianceAt(4, 4)[i], 0.5, 0.5e-3);
}

TEST_F(HostAirTest, AnObjectAtTheSeaIsBehindTheAirOfTheSea) {
  // An object as bright as the water is without air, where the water is.
  constexpr float kAxial = 12000;
  SyntheticScene sea = sceneOf(3000, 0.26, kAxial, {});
  sea.withHost = false;
  sea.fillWater(kAxial);
  sea.render(device());
  const glm::vec3 hazy = sea.radianceAt(4, 4);
  sea.light.rayleighExtinction = sea.light.mieExtinction = glm::vec4(0, 0, 0, 1000);
  sea.render(device());
  const glm::vec3 bare = sea.radianceAt(4, 4);
  SyntheticScene object = sceneOf(3000, 0.26, kAxial, {bare.x, bare.y, bare.z, 1});
  object.render(device());
  const Path path = pathOf(object, kAxial);
  ASSERT_LT(std::abs(path.heightAt(path.length)), 100);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(object.radianceAt(4, 4)[i] / hazy[i], 1, 5e-3);
}

TEST_F(HostAirTest, CloudsHideWhatIsBehindThemAlone) {
  const std::array<float, 4> clouds{0.6f, 0.5f, 0.4f, 0.25f};
  struct Case {
    double eye, pitch;
    float axial;
    double share;  // of the layer, 800 to 1500 m, before the object; less than 0: as its height says
  };
  for (const Case& c : {Case{3, 0, 5000, 0}, Case{3, -0.7, 1000, 0}, Case{3, -0.7, 4000, 1}, Case{3, -0.7, 1700, -1},
                        Case{3000, 0.7, 1000, 0}, Case{3000, 0.7, 4000, 1}, Case{3000, -0.3, 5000, 0}}) {
    SyntheticScene scene = sceneOf(c.eye, c.pitch, c.axial, {0.5f, 0.5f, 0.5f, 1});
    scene.light.cloudPlace.w = 800;
    scene.light.cloudSun.w = 1500;
    scene.render(device());
    const glm::vec3 bare = scene.radianceAt(4, 4);
    scene.clouds = clouds;
    scene.render(device());
    const Path path = pathOf(scene, c.axial);
    const double share = c.share < 0 ? (path.heightAt(path.length) - 800) / 700 : c.share;
    ASSERT_TRUE(share >= 0 && share <= 1) << c.eye << ' ' << c.axial;
    const double through = std::pow(0.25, share);
    for (int i = 0; i < 3; ++i) {
      const double expected =
          static_cast<double>(bare[i]) * through + clouds[static_cast<std::size_t>(i)] * (1 - through) / 0.75;
      EXPECT_NEAR(scene.radianceAt(4, 4)[i] / expected, 1, 2e-3) << c.eye << ' ' << c.axial << ' ' << share;
    }
  }
}

TEST_F(HostAirTest, AHostMayBringItsOwn) {
  SyntheticScene scene = sceneOf(3, 0, 20000, {7, 8, 9, 1});
  scene.clouds = {0.6f, 0.5f, 0.4f, 0.25f};
  scene.light.cloudSun.w = 1;  // over a base of 0
  scene.airBeforeHost = false;
  scene.render(device());
  EXPECT_EQ(scene.radianceAt(4, 4), glm::vec3(7, 8, 9));
}

}  // namespace
