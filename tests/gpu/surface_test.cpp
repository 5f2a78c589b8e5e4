#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <optional>

#include "support/gpu_test.hpp"
#include "surface_scene.hpp"

namespace {

using surface_scene::Lens;
using surface_scene::SyntheticSea;
using surface_scene::Water;
using surface_scene::Wave;

constexpr double kDegree = std::numbers::pi / 180;
constexpr VkExtent2D kExtent{96, 54};

double between(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Heights from a hand above the water to the stratosphere, every lens and attitude that looks at the sea.
pelagic::Camera randomCamera(std::mt19937& random, double lowest, double highest) {
  Lens lens;
  lens.fov = 2 * std::pow(60.0, between(random, 0, 1)) * kDegree;
  lens.reversed = random() % 4 != 0;
  lens.flipped = random() % 2 == 0;
  if (random() % 4 == 0) lens.shift = {between(random, -0.8, 0.8), between(random, -0.8, 0.8)};
  if (!lens.reversed) lens.far = 1e4;
  const double roll = random() % 2 == 0 ? between(random, -180, 180) : 0;
  const double pitch = random() % 8 == 0 ? -90 : between(random, -90, 20);
  const glm::dvec3 position(between(random, -1e6, 1e6), lowest * std::pow(highest / lowest, between(random, 0, 1)),
                            between(random, -1e6, 1e6));
  return surface_scene::camera(position, between(random, -180, 180) * kDegree, pitch * kDegree, roll * kDegree, lens,
                               kExtent);
}

class SurfaceTest : public support::GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    ASSERT_FALSE(HasFatalFailure());
  }
  void TearDown() override {
    view_.reset();
    surface_.reset();
    sea_.reset();
    GpuTest::TearDown();
  }
  void makeSea(const Wave& now, const Wave& before) { sea_.emplace(gpu(), now, before); }
  void makeView(VkExtent2D extent, float targetEdge) {
    auto surface = pelagic::Surface::create(device(), {targetEdge});
    ASSERT_TRUE(surface) << surface.error().message;
    surface_.emplace(std::move(*surface));
    auto view = pelagic::SurfaceView::create(*surface_, sea_->maps(), extent);
    ASSERT_TRUE(view) << view.error().message;
    view_.emplace(std::move(*view));
  }
  Water draw(const pelagic::Camera& camera) {
    gpu().run([&](vk::CommandBuffer commands) { view_->record(commands, sea_->maps(), camera); });
    return surface_scene::read(gpu(), view_->buffer());
  }
  std::uint32_t drawnBlocks() {
    VkDrawIndexedIndirectCommand command{};
    const auto bytes = common::readBuffer(gpu(), view_->drawArguments(), sizeof(command));
    std::memcpy(&command, bytes.data(), sizeof(command));
    return command.instanceCount;
  }

  std::optional<SyntheticSea> sea_;
  std::optional<pelagic::Surface> surface_;
  std::optional<pelagic::SurfaceView> view_;
};

TEST_F(SurfaceTest, FlatSeaIsTheSphere) {
  makeSea({}, {});
  makeView(kExtent, 8);
  std::mt19937 random(1);
  for (int n = 0; n < 240; ++n) {
    const pelagic::Camera camera = randomCamera(random, 0.3, 20e3);
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
          const double distance = surface_scene::hitSphere(camera, direction);
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
        // Reversed depth is as exact far away as nearby.
        const double rounding = camera.reversedDepth ? 1e-4 * high.y : 1e-6;
        wrongDepth += depth < low.y - rounding || depth > high.y + rounding;
        const glm::dvec2 at(water.position[2 * i], water.position[2 * i + 1]);
        const double slack = 1e-3 + 1e-5 * glm::length(at);
        wrongPosition += at.x < low.x - slack || at.x > high.x + slack || at.y < low.z - slack || at.y > high.z + slack;
      }
    }
    EXPECT_EQ(holes, 0) << "camera " << n << " at " << camera.position.y << " m, " << hits << " pixels of water";
    EXPECT_EQ(excess, 0) << "camera " << n << " at " << camera.position.y << " m";
    EXPECT_EQ(wrongDepth, 0) << "camera " << n << " at " << camera.position.y << " m";
    EXPECT_EQ(wrongPosition, 0) << "camera " << n << " at " << camera.position.y << " m";
  }
}

}  // namespace
