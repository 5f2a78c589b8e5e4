/// Short waves on a long one: steep on its crest, calm in its trough, in the mean as many as without it.
#include <algorithm>
#include <numbers>
#include <pelagic/ocean.hpp>

#include "support/gpu_test.hpp"

namespace {

using namespace pelagic;

constexpr std::uint32_t kSide = 96;  ///< Of the picture [px].
constexpr double kHeight = 200;      ///< Of the camera, which looks straight down [m].
constexpr float kFocal = 2;          ///< The picture is as wide as the camera is high.

using OceanModulationTest = support::GpuTest;

// Of the random waves nothing is left but the tail that no cascade holds, so that what pixels do not resolve is that
// tail times the energy of short waves.
TEST_F(OceanModulationTest, RipplesAreSteepOnCrestsAndCalmInTroughs) {
  OceanInfo info;
  info.waves.sea.windSpeed = 6;
  info.waves.sea.octaveGain.fill(0);
  constexpr double kLength = 100, kSteepness = 0.2;
  info.waves.sea.trochoids = {{kSteepness * kLength / (2 * std::numbers::pi), kLength, 0}};
  info.waves.precision = MapPrecision::single;
  info.waves.layout = waveLayout(info.waves.sea).value();
  const auto image = [&](vk::Format format) {
    return common::createImage(gpu(), format, {kSide, kSide},
                               vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eTransferSrc, "modulation");
  };
  const auto output = image(vk::Format::eR16G16B16A16Sfloat), variance = image(vk::Format::eR32G32Sfloat);
  const auto depth = image(vk::Format::eR32Sfloat);
  CompositeTargets targets;
  targets.output = output.host({}, common::kTransferSource);
  targets.slopeVariance = variance.host({}, common::kTransferSource);
  targets.mergedDepth = depth.host({}, common::kTransferSource);
  auto ocean = Ocean::create(device(), info);
  ASSERT_TRUE(ocean) << ocean.error().message;
  auto view = ocean->createView(targets);
  ASSERT_TRUE(view) << view.error().message;
  Camera camera;
  camera.position = {7, kHeight, -3};
  camera.rotation = glm::mat3(1, 0, 0, 0, 0, 1, 0, -1, 0);
  camera.projection = {{kFocal, 0, 0, 0}, {0, -kFocal, 0, 0}, {0, 0, 0, -1}, {0, 0, 0.1f, 0}};
  gpu().run([&](vk::CommandBuffer commands) {
    ocean->record(commands, 10);
    view->record(commands, camera);
  });
  const auto read = [&](const common::OwnedImage& from) {
    return common::readFloats(gpu(), *from.image, from.format, from.extent, common::kTransferSource);
  };
  const auto left = read(variance), depths = read(depth);

  const Trochoid wave = ocean->waves().trochoids().at(0);
  const double steepness = 2 * std::numbers::pi / wave.wavelength * wave.amplitude * wave.steepness;
  ASSERT_NEAR(steepness, kSteepness, 0.01);
  // Across the long wave, which has no slope of its own there.
  const auto tail = static_cast<double>(ocean->waves().maps().unresolved.crosswind);
  ASSERT_GT(tail, 1e-4);
  const auto share = [&](std::size_t i) { return static_cast<double>(left[2 * i + 1]) / tail; };
  double sum = 0;
  std::size_t calmest = 0, steepest = 0;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    sum += share(i);
    if (share(i) < share(calmest)) calmest = i;
    if (share(i) > share(steepest)) steepest = i;
  }
  const auto expected = [](double a) { return 1 + 3 * a * (1 + a); };
  EXPECT_NEAR(share(steepest), expected(steepness), 0.03);
  EXPECT_NEAR(share(calmest), expected(-steepness), 0.03);
  const auto [lowest, highest] = std::minmax_element(depths.begin(), depths.end());  // 1 / distance
  EXPECT_NEAR(depths[steepest], *highest, 0.15f * (*highest - *lowest));
  EXPECT_NEAR(depths[calmest], *lowest, 0.15f * (*highest - *lowest));
  // 200 m are two waves.
  EXPECT_NEAR(sum / static_cast<double>(depths.size()), 1, 0.02);
}

}  // namespace
