#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <pelagic/ocean.hpp>
#include <pelagic/query.hpp>

#include "support/even_gain.hpp"
#include "support/gpu_test.hpp"

namespace {

using namespace pelagic;

constexpr VkExtent2D kExtent{160, 90};

/// Looks down on the sea from 30 m.
Camera camera() {
  Camera result;
  result.position = {3, 30, -8};
  const glm::vec3 forward{0.8f, -0.6f, 0};
  result.rotation = glm::mat3(glm::lookAt(glm::vec3(0), forward, glm::vec3(0, 1, 0)));
  const float f = 1 / std::tan(0.45f);
  const float aspect = static_cast<float>(kExtent.width) / static_cast<float>(kExtent.height);
  result.projection = {{f / aspect, 0, 0, 0}, {0, -f, 0, 0}, {0, 0, 0, -1}, {0, 0, 0.1f, 0}};
  return result;
}

struct Picture {
  std::vector<float> normal;    ///< And foam.
  std::vector<float> variance;  ///< Along x and z.
  std::vector<float> depth;
  SlopeVariance unresolved;
};

class OceanGainTest : public support::GpuTest {
 protected:
  static OceanInfo ocean(double wind = 9) {
    OceanInfo info;
    info.waves.sea.windSpeed = wind;
    info.waves.layout = waveLayout(info.waves.sea, 3, 64).value();
    info.waves.precision = MapPrecision::single;
    return info;
  }
  common::OwnedImage image(vk::Format format) {
    return common::createImage(gpu(), format, kExtent,
                               vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eTransferSrc, "gain test");
  }
  std::vector<float> read(const common::OwnedImage& image) {
    return common::readFloats(gpu(), *image.image, image.format, image.extent, common::kTransferSource);
  }
  Picture draw(const OceanInfo& info, const std::optional<GainMap>& later = {}) {
    const auto output = image(vk::Format::eR32G32B32A32Sfloat), normal = image(vk::Format::eR32G32B32A32Sfloat);
    const auto variance = image(vk::Format::eR32G32Sfloat), depth = image(vk::Format::eR32Sfloat);
    auto made = Ocean::create(device(), info);
    EXPECT_TRUE(made) << (made ? "" : made.error().message);
    if (later) {
      EXPECT_TRUE(made->setGain(*later));
    }
    CompositeTargets targets;
    targets.output = output.host({}, common::kTransferSource);
    targets.normal = normal.host({}, common::kTransferSource);
    targets.slopeVariance = variance.host({}, common::kTransferSource);
    targets.mergedDepth = depth.host({}, common::kTransferSource);
    auto view = made->createView(targets);
    EXPECT_TRUE(view) << (view ? "" : view.error().message);
    gpu().run([&](vk::CommandBuffer commands) {
      made->record(commands, 40);
      view->record(commands, camera());
    });
    return {read(normal), read(variance), read(depth), made->waves().maps().unresolved};
  }
};

double meanFoam(const Picture& picture) {
  double sum = 0;
  for (std::size_t i = 3; i < picture.normal.size(); i += 4) sum += picture.normal[i];
  return sum / (kExtent.width * kExtent.height);
}

TEST_F(OceanGainTest, OneEverywhereChangesNothing) {
  OceanInfo info = ocean(14);
  const Picture plain = draw(info);
  info.waves.gain = support::evenGain(1);
  const Picture gained = draw(info);
  EXPECT_EQ(plain.depth, gained.depth);
  EXPECT_EQ(plain.normal, gained.normal);
  EXPECT_EQ(plain.variance, gained.variance);
}

TEST_F(OceanGainTest, HalfEverywhereIsTheSeaOfHalfTheAmplitudes) {
  for (const double choppiness : {1.0, 0.0}) {
    OceanInfo info = ocean();
    info.waves.sea.choppiness = choppiness;
    info.waves.gain = support::evenGain(0.5f);
    const Picture gained = draw(info);
    info.waves.gain = {};
    info.waves.sea.octaveGain.fill(0.5);
    const Picture calm = draw(info);
    for (std::size_t i = 0; i < calm.depth.size(); ++i) {
      EXPECT_NEAR(gained.depth[i], calm.depth[i], 1e-5f * calm.depth[i]);
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(gained.normal[4 * i + c], calm.normal[4 * i + c], 1e-3);
      // The wind blows along x. What no cascade holds is scaled with the rest here, and fills up the measured slopes
      // there; long waves that push the water together change it from place to place.
      if (choppiness > 0) continue;
      const double x = static_cast<double>(gained.variance[2 * i]) - 0.25 * gained.unresolved.upwind;
      const double z = static_cast<double>(gained.variance[2 * i + 1]) - 0.25 * gained.unresolved.crosswind;
      EXPECT_NEAR(x, static_cast<double>(calm.variance[2 * i]) - calm.unresolved.upwind, 1e-5);
      EXPECT_NEAR(z, static_cast<double>(calm.variance[2 * i + 1]) - calm.unresolved.crosswind, 1e-5);
    }
  }
}

TEST_F(OceanGainTest, FoamFollows) {
  OceanInfo info = ocean(18);
  info.waves.gain = support::evenGain(1);
  const double usual = meanFoam(draw(info));
  ASSERT_GT(usual, 0.003);
  const double lull = meanFoam(draw(info, support::evenGain(0.8f)));
  const double gust = meanFoam(draw(info, support::evenGain(1.15f)));
  EXPECT_LT(lull, 0.7 * usual);
  EXPECT_GT(lull, 0);
  EXPECT_GT(gust, usual);
  EXPECT_EQ(meanFoam(draw(info, support::evenGain(0))), 0);
}

// A slick beyond a line across the picture: flat there, as it was before it.
TEST_F(OceanGainTest, TheDrawnSurfaceIsThatOfTheQueries) {
  OceanInfo info = ocean(12);
  GainMap slick;
  slick.origin = {20, 0};
  slick.spacing = 30;
  slick.width = slick.height = 2;
  slick.bands = 3;
  slick.gains = {1, 0, 1, 0, 1, 0.5f, 1, 0.5f, 1, 1, 1, 1};
  info.waves.gain = slick;
  const Picture picture = draw(info);
  auto query = SeaQuery::create(info.waves);
  ASSERT_TRUE(query);
  query->setTime(40);
  const Camera eye = camera();
  const glm::mat4 toWorld = glm::inverse(eye.projection * glm::mat4(eye.rotation));
  double worst = 0;
  int seen = 0;
  for (std::uint32_t y = 40; y < kExtent.height; y += 5) {
    for (std::uint32_t x = 5; x < kExtent.width; x += 5) {
      const glm::vec4 clip((static_cast<float>(x) + 0.5f) / 80 - 1, (static_cast<float>(y) + 0.5f) / 45 - 1,
                           picture.depth[y * kExtent.width + x], 1);
      const glm::vec4 p = toWorld * clip;
      const glm::dvec3 world = eye.position + glm::dvec3(p) / static_cast<double>(p.w);
      if (world.y < -20 || std::abs(world.x) > 400) continue;
      worst = std::max(worst, std::abs(query->heightAt({world.x, world.z}) - world.y));
      ++seen;
    }
  }
  EXPECT_GT(seen, 200);
  EXPECT_LT(worst, 0.25) << "waves shorter than a cell of the grid are left to shading";
}

TEST_F(OceanGainTest, BadMapsChangeNothing) {
  OceanInfo info = ocean();
  auto without = Ocean::create(device(), info);
  ASSERT_TRUE(without);
  EXPECT_EQ(without->setGain(support::evenGain(1)).error().message,
            "GainMap has 2 x 2 samples, it must have 0 x 0 as the one that the simulation was created with");
  info.waves.gain = support::evenGain(1);
  info.waves.gain.gains[2] = 5;
  EXPECT_EQ(Ocean::create(device(), info).error().message, "GainMap::gains[2] is 5, it must lie in 0 … 4");
}

}  // namespace
