/// The undisplaced sea: a sphere of any radius.
#include "surface_fixture.hpp"

namespace {

using namespace surface_scene;

constexpr double kMoon = 1737.4e3;  // [m]

class SurfacePlanetTest : public SurfaceTest {
 protected:
  void expectSphere(double planetRadius, int cameras) {
    makeView(kExtent, 8, false, planetRadius);
    std::mt19937 random(1);
    for (int n = 0; n < cameras; ++n) {
      const pelagic::Camera camera = randomCamera(random, 0.3, 20e3, kExtent);
      const Water water = draw(camera);
      int holes = 0, excess = 0, wrongDepth = 0, wrongPosition = 0, hits = 0;
      for (std::uint32_t y = 0; y < kExtent.height; ++y) {
        for (std::uint32_t x = 0; x < kExtent.width; ++x) {
          // The rays through the pixel's neighbourhood bound what it may show.
          int hitting = 0;
          glm::dvec3 low(1e30), high(-1e30);  // ground x, depth, ground z
          for (const glm::dvec2 offset :
               {glm::dvec2(0, 0), glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
            const glm::dvec3 direction =
                surface_scene::ray(camera, water.uv(x, y) + offset / glm::dvec2(kExtent.width, kExtent.height));
            const double distance = surface_scene::hitSphere(camera, direction, 0, planetRadius);
            if (distance < 0) continue;
            ++hitting;
            const glm::dvec3 point = distance * direction;
            const double depth = std::clamp(surface_scene::project(camera, point).z, 0.0, 1.0);
            low = glm::min(low, {point.x, depth, point.z});
            high = glm::max(high, {point.x, depth, point.z});
          }
          const bool covered = water.covered(x, y);
          hits += hitting == 5;
          holes += hitting == 5 && !covered;
          excess += hitting == 0 && covered;
          if (hitting != 5 || !covered) continue;
          const std::size_t i = water.index(x, y);
          const double depth = static_cast<double>(water.depth[i]);
          // Reversed depth is as exact far away as nearby; chords lie visibly below a small planet only.
          const double rounding = camera.reversedDepth ? (1e-4 + 100 / planetRadius) * high.y : 1e-6;
          wrongDepth += depth < low.y - rounding || depth > high.y + rounding;
          const glm::dvec2 at(water.position[2 * i], water.position[2 * i + 1]);
          const double slack = 1e-3 + 1e-5 * glm::length(at);
          wrongPosition +=
              at.x < low.x - slack || at.x > high.x + slack || at.y < low.z - slack || at.y > high.z + slack;
        }
      }
      EXPECT_EQ(holes, 0) << "camera " << n << " at " << camera.position.y << " m, " << hits << " pixels of water";
      EXPECT_EQ(excess, 0) << "camera " << n << " at " << camera.position.y << " m";
      EXPECT_EQ(wrongDepth, 0) << "camera " << n << " at " << camera.position.y << " m";
      EXPECT_EQ(wrongPosition, 0) << "camera " << n << " at " << camera.position.y << " m";
    }
  }
};

TEST_F(SurfacePlanetTest, FlatSeaIsTheSphere) {
  makeSea({}, {});
  expectSphere(pelagic::kEarthRadius, 240);
}

TEST_F(SurfacePlanetTest, OfAnyRadius) {
  makeSea({}, {});
  for (const double planetRadius : {1e5, kMoon, 1e8}) expectSphere(planetRadius, 60);
}

/// The horizon lies acos(R / (R + h)) below the horizontal.
TEST_F(SurfacePlanetTest, HorizonDips) {
  const VkExtent2D extent{192, 108};
  makeSea({}, {});
  for (const double planetRadius : {1e5, kMoon, pelagic::kEarthRadius, 1e8}) {
    makeView(extent, 12, false, planetRadius);
    EXPECT_EQ(view_->buffer().planetRadius, planetRadius);
    for (const double height : {0.3, 3.0, 300.0, 20e3}) {
      const double dip = std::acos(planetRadius / (planetRadius + height));
      // Two degrees of it in the middle of the picture; roll spreads the phases of the pixels.
      const Water water = draw(camera({5e5, height, -1e7}, 1, -dip, 0.1, {2 * kDegree}, extent));
      double drawn = 0, expected = 0;
      for (std::uint32_t y = 0; y < extent.height; ++y) {
        for (std::uint32_t x = 0; x < extent.width; ++x) {
          const glm::dvec3 direction =
              glm::normalize(ray(camera({0, height, 0}, 1, -dip, 0.1, {2 * kDegree}, extent), water.uv(x, y)));
          drawn += water.covered(x, y);
          expected += -std::asin(direction.y) > dip;
        }
      }
      // Mean distance of the edges [px], 0.32 mrad each.
      EXPECT_NEAR((drawn - expected) / extent.width, 0, 0.1) << planetRadius << " m, from " << height << " m";
    }
  }
}

}  // namespace
