/// What the tests of the surface stage share: one sea, one surface, one view.
#pragma once

#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>
#include <pelagic/query.hpp>

#include "support/gpu_test.hpp"
#include "surface_scene.hpp"

namespace surface_scene {

inline constexpr double kDegree = std::numbers::pi / 180;
inline constexpr VkExtent2D kExtent{96, 54};

inline double between(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Heights from a hand above the water to the stratosphere, every lens and attitude that looks at the sea.
inline pelagic::Camera randomCamera(std::mt19937& random, double lowest, double highest, VkExtent2D extent) {
  Lens lens;
  lens.fov = 2 * std::pow(60.0, between(random, 0, 1)) * kDegree;
  lens.reversed = random() % 4 != 0;
  lens.flipped = random() % 2 == 0;
  if (random() % 4 == 0) lens.shift = {between(random, -0.8, 0.8), between(random, -0.8, 0.8)};
  if (!lens.reversed) lens.far = 1e4;
  const double roll = random() % 2 == 0 ? between(random, -180, 180) : 0;
  const double pitch = random() % 8 == 0 ? -90 : between(random, -90, 20);
  const glm::dvec3 position(between(random, -1e7, 1e7), lowest * std::pow(highest / lowest, between(random, 0, 1)),
                            between(random, -1e7, 1e7));
  return camera(position, between(random, -180, 180) * kDegree, pitch * kDegree, roll * kDegree, lens, extent);
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
    waves_.reset();
    GpuTest::TearDown();
  }
  void makeSea(const Wave& now, const Wave& before) {
    sea_.emplace(gpu(), now, before);
    maps_ = sea_->maps();
  }
  /// A sea of the wave stage, as the maps and as single points.
  void makeWaves(const pelagic::SeaState& sea, std::uint32_t cascades = 4, std::uint32_t size = 256) {
    pelagic::WavesInfo info;
    info.sea = sea;
    info.layout = pelagic::waveLayout(sea, cascades, size).value();
    auto waves = pelagic::Waves::create(device(), info);
    ASSERT_TRUE(waves) << waves.error().message;
    waves_.emplace(std::move(*waves));
    query_.emplace(pelagic::SeaQuery::create(info).value());
    setTime(0);
  }
  void setTime(double time) {
    gpu().run([&](vk::CommandBuffer commands) { waves_->record(commands, time); });
    query_->setTime(time);
    maps_ = waves_->maps();
  }
  void makeView(VkExtent2D extent, float targetEdge, bool motionVectors = false,
                double planetRadius = pelagic::kEarthRadius) {
    auto surface = pelagic::Surface::create(device(), {targetEdge, motionVectors, planetRadius});
    ASSERT_TRUE(surface) << surface.error().message;
    surface_.emplace(std::move(*surface));
    auto view = pelagic::SurfaceView::create(*surface_, maps_, extent);
    ASSERT_TRUE(view) << view.error().message;
    view_.emplace(std::move(*view));
  }
  Water draw(const pelagic::Camera& camera) {
    gpu().run([&](vk::CommandBuffer commands) { view_->record(commands, maps_, camera); });
    return read(gpu(), view_->buffer());
  }
  std::uint32_t drawnBlocks() {
    VkDrawIndexedIndirectCommand command{};
    const auto bytes = common::readBuffer(gpu(), view_->drawArguments(), sizeof(command));
    std::memcpy(&command, bytes.data(), sizeof(command));
    return command.instanceCount;
  }

  std::optional<SyntheticSea> sea_;
  std::optional<pelagic::Waves> waves_;
  std::optional<pelagic::SeaQuery> query_;
  pelagic::WaveMaps maps_;
  std::optional<pelagic::Surface> surface_;
  std::optional<pelagic::SurfaceView> view_;
};

}  // namespace surface_scene
