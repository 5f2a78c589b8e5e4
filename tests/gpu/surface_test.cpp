#include <limits>

#include "surface_fixture.hpp"
#include "water_defects.hpp"

namespace {

using namespace surface_scene;

TEST_F(SurfaceTest, WavesLeaveNoHole) {
  const Wave wave{2, {8, 3}, 0.9, 0.4};
  makeSea(wave, wave);
  makeView(kExtent, 8);
  std::mt19937 random(2);
  int inTroughs = 0, fromBelow = 0;
  for (int n = 0; n < 400; ++n) {
    pelagic::Camera camera = randomCamera(random, 0.3, 2e3, kExtent);
    const double surface = wave.heightBelow({camera.position.x, camera.position.z});
    if (n % 2 == 1) camera.position.y = surface + between(random, 0.5, 4);
    if (n % 8 == 0) {
      const Lens lens{between(random, 20, 100) * kDegree};
      camera = surface_scene::camera({camera.position.x, between(random, -30, -3), camera.position.z},
                                     between(random, -3, 3), between(random, -0.2, 1.5), 0, lens, kExtent);
    }
    const bool below = camera.position.y < surface;
    if (std::abs(camera.position.y - surface) < 0.5) continue;
    fromBelow += below;
    inTroughs += !below && camera.position.y < wave.amplitude;
    const Water water = draw(camera);
    int holes = 0;
    for (std::uint32_t y = 0; y < kExtent.height; ++y) {
      for (std::uint32_t x = 0; x < kExtent.width; ++x) {
        // A ray that leaves the layer in which all crests and troughs lie has crossed the surface.
        const double level = below ? wave.amplitude : -wave.amplitude;
        holes += !water.covered(x, y) && mustShowWater(camera, water.uv(x, y), kExtent, level);
      }
    }
    EXPECT_EQ(holes, 0) << "camera " << n << " at " << camera.position.y << " m, water at " << surface << " m";
  }
  EXPECT_GE(inTroughs, 50);
  EXPECT_GE(fromBelow, 40);
}

TEST_F(SurfaceTest, DisplacedPointsAreWhereThePictureShowsThem) {
  const Wave wave{1.5, {4, 2}, 0.9, 1};
  const VkExtent2D extent{160, 90};
  makeSea(wave, wave);
  makeView(extent, 4);
  for (int n = 0; n < 8; ++n) {
    const pelagic::Camera camera = surface_scene::camera({3210.5 * n, 4.0 + 2 * n, -777.25 * n}, 0.8 * n,
                                                         -0.25 - 0.15 * n, 0.4 * n, {60 * kDegree}, extent);
    const Water water = draw(camera);
    int pixels = 0;
    for (std::uint32_t y = 0; y < extent.height; ++y) {
      for (std::uint32_t x = 0; x < extent.width; ++x) {
        const std::size_t i = water.index(x, y);
        const glm::dvec2 ground(water.position[2 * i], water.position[2 * i + 1]);
        // Farther out the wave is below the spacing of the grid.
        if (!water.covered(x, y) || glm::length(ground) > 40) continue;
        const glm::dvec3 displacement = wave.at(glm::dvec2(camera.position.x, camera.position.z) + ground);
        const glm::dvec3 point = displacement + glm::dvec3(ground.x, seaLevel(ground) - camera.position.y, ground.y);
        const glm::dvec2 miss =
            (glm::dvec2(project(camera, point)) - water.uv(x, y)) * glm::dvec2(extent.width, extent.height);
        EXPECT_LT(glm::length(miss), 1) << "camera " << n << ", pixel " << x << ", " << y;
        ++pixels;
      }
    }
    EXPECT_GT(pixels, 3000) << "camera " << n;
  }
}

TEST_F(SurfaceTest, FirstFrameStandsStill) {
  makeSea({2, {8, 3}, 0.9, 0.4}, {2, {8, 3}, 0.9, 0});
  makeView(kExtent, 8, true);
  const Water water = draw(surface_scene::camera({0, 5, 0}, 0, -0.3, 0, {1}, kExtent));
  for (std::uint32_t y = 0; y < kExtent.height; ++y) {
    for (std::uint32_t x = 0; x < kExtent.width; ++x) {
      if (!water.covered(x, y)) continue;
      ASSERT_EQ(water.motion[2 * water.index(x, y)], 0.0f);
      ASSERT_EQ(water.motion[2 * water.index(x, y) + 1], 0.0f);
    }
  }
}

TEST_F(SurfaceTest, MotionIsThatOfTheWaterPoint) {
  const Wave now{1.5, {4, 2}, 0.9, 1};
  Wave before = now;
  before.phase = 0.3;
  const VkExtent2D extent{160, 90};
  makeSea(now, before);
  makeView(extent, 4, true);
  const pelagic::Camera old = surface_scene::camera({1e5, 6, -3e5}, 0.5, -0.4, 0.1, {60 * kDegree}, extent);
  const pelagic::Camera moved =
      surface_scene::camera({1e5 + 0.7, 6.4, -3e5 - 0.5}, 0.55, -0.37, 0.12, {55 * kDegree}, extent);
  draw(old);
  const Water water = draw(moved);
  int pixels = 0;
  double largest = 0;
  for (std::uint32_t y = 0; y < extent.height; ++y) {
    for (std::uint32_t x = 0; x < extent.width; ++x) {
      const std::size_t i = water.index(x, y);
      const glm::dvec2 ground(water.position[2 * i], water.position[2 * i + 1]);
      if (!water.covered(x, y) || glm::length(ground) > 40) continue;
      const glm::dvec2 world = ground + glm::dvec2(moved.position.x, moved.position.z);
      const glm::dvec2 oldGround = world - glm::dvec2(old.position.x, old.position.z);
      const glm::dvec3 oldPoint =
          before.at(world) + glm::dvec3(oldGround.x, seaLevel(oldGround) - old.position.y, oldGround.y);
      const glm::dvec2 expected = water.uv(x, y) - glm::dvec2(project(old, oldPoint));
      const glm::dvec2 size(extent.width, extent.height);
      const glm::dvec2 miss = (glm::dvec2(water.motion[2 * i], water.motion[2 * i + 1]) - expected) * size;
      EXPECT_LT(glm::length(miss), 0.5) << "pixel " << x << ", " << y;
      largest = std::max(largest, glm::length(expected * size));
      ++pixels;
    }
  }
  EXPECT_GT(pixels, 4000);
  EXPECT_GT(largest, 10) << "the waves and the camera must move the water much farther than the tolerance";
}

TEST_F(SurfaceTest, MotionIsLeftOnlyWhenAskedForAndChangesNothingElse) {
  const Wave wave{1.5, {8, 3}, 0.9, 0.4};
  makeSea(wave, wave);
  const auto camera = surface_scene::camera({30, 4, 5}, 0.3, -0.2, 0.1, {1}, kExtent);
  makeView(kExtent, 12);
  EXPECT_EQ(view_->buffer().motion.view, VkImageView{VK_NULL_HANDLE});
  const Water without = draw(camera);
  EXPECT_TRUE(without.motion.empty());
  makeView(kExtent, 12, true);
  const Water with = draw(camera);
  EXPECT_EQ(with.motion.size(), 2u * kExtent.width * kExtent.height);
  EXPECT_EQ(with.body, without.body);
  EXPECT_EQ(with.depth, without.depth);
  for (std::uint32_t i = 0; i < kExtent.width * kExtent.height; ++i) {
    if (with.body[i] == 0) continue;
    ASSERT_EQ(with.position[2 * i], without.position[2 * i]);
    ASSERT_EQ(with.position[2 * i + 1], without.position[2 * i + 1]);
  }
}

TEST_F(SurfaceTest, DrawsLittleThatIsNotSeen) {
  const VkExtent2D extent{640, 360};
  const Wave wave{1.2, {20, 8}, 0.9, 0};
  makeSea(wave, wave);
  makeView(extent, 8);
  for (const double pitch : {-1.4, -0.6, -0.2, 0.0, 0.2}) {
    const Water water = draw(surface_scene::camera({50, 6, 70}, 1, pitch, 0, {60 * kDegree}, extent));
    double covered = 0;
    for (const float body : water.body) covered += static_cast<double>(body);
    // Cells of 8 x 8 pixels, 15 x 15 of them a block. Rows are closer where waves are large, and the picture's edge
    // cuts blocks.
    const double blocks = covered / (8 * 8 * 15 * 15);
    EXPECT_LE(drawnBlocks(), 2 * blocks + 16) << "pitch " << pitch << ", " << blocks << " blocks would do";
  }
}

TEST_F(SurfaceTest, NothingIsDrawnWhereNoWaterCanBe) {
  makeSea({1, {8, 3}, 0.9, 0.4}, {1, {8, 3}, 0.9, 0.4});
  makeView(kExtent, 8);
  draw(surface_scene::camera({0, 50, 0}, 0, 1, 0, {1}, kExtent));
  EXPECT_EQ(drawnBlocks(), 0u);
  draw(surface_scene::camera({0, std::numeric_limits<double>::quiet_NaN(), 0}, 0, -1, 0, {1}, kExtent));
  EXPECT_EQ(drawnBlocks(), 0u);
  draw(surface_scene::camera({0, 50, 0}, 0, -1, 0, {1}, kExtent));
  EXPECT_GT(drawnBlocks(), 0u);
}

TEST_F(SurfaceTest, ViewsDoNotDisturbEachOther) {
  const Wave wave{1, {8, 3}, 0.9, 0.4};
  makeSea(wave, wave);
  makeView(kExtent, 8);
  const auto near = surface_scene::camera({0, 3, 0}, 0, -0.2, 0, {1}, kExtent);
  const VkExtent2D otherExtent{70, 40};
  const auto far = surface_scene::camera({9e3, 900, 5e4}, 2, -0.9, 1, {0.5}, otherExtent);
  const Water alone = draw(near);

  auto other = pelagic::SurfaceView::create(*surface_, maps_, otherExtent);
  ASSERT_TRUE(other) << other.error().message;
  gpu().run([&](vk::CommandBuffer commands) {
    view_->record(commands, maps_, near);
    other->record(commands, maps_, far);
  });
  const Water together = read(gpu(), view_->buffer());
  EXPECT_EQ(alone.body, together.body);
  EXPECT_EQ(alone.depth, together.depth);
  const Water second = read(gpu(), other->buffer());
  EXPECT_EQ(second.body, std::vector<float>(second.body.size(), 1.0f));
}

TEST_F(SurfaceTest, BadValuesAreNamed) {
  makeSea({}, {});
  for (const float edge :
       {0.0f, 1.9f, 65.0f, -8.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    const auto surface = pelagic::Surface::create(device(), {edge});
    ASSERT_FALSE(surface) << edge;
    EXPECT_EQ(surface.error().code, pelagic::ErrorCode::invalidArgument);
    EXPECT_NE(surface.error().message.find("SurfaceInfo::targetEdge is "), std::string::npos);
  }
  for (const double radius : {0.0, 0.99e5, 1.01e8, -6.4e6, std::nan(""), HUGE_VAL}) {
    const auto surface = pelagic::Surface::create(device(), {12, false, radius});
    ASSERT_FALSE(surface) << radius;
    EXPECT_EQ(surface.error().code, pelagic::ErrorCode::invalidArgument);
    EXPECT_NE(surface.error().message.find("SurfaceInfo::planetRadius is "), std::string::npos);
  }
  makeView(kExtent, 8);
  for (const VkExtent2D extent : {VkExtent2D{0, 10}, VkExtent2D{10, 0}, VkExtent2D{16385, 10}, VkExtent2D{10, ~0u}}) {
    const auto view = pelagic::SurfaceView::create(*surface_, maps_, extent);
    ASSERT_FALSE(view);
    EXPECT_EQ(view.error().code, pelagic::ErrorCode::invalidArgument);
    EXPECT_NE(view.error().message.find("extent is " + std::to_string(extent.width)), std::string::npos);
  }
  pelagic::WaveMaps maps = maps_;
  maps.displacementPair[1] = {};
  const auto view = pelagic::SurfaceView::create(*surface_, maps, kExtent);
  ASSERT_FALSE(view);
  EXPECT_NE(view.error().message.find("displacementPair[1]"), std::string::npos);
}

}  // namespace
