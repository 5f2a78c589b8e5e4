#include <cmath>
#include <cstring>
#include <numbers>
#include <pelagic/sky.hpp>

#include "pelagic/shader/sky_light.h"
#include "physics/cloud_weather.glsl"
#include "physics/clouds.glsl"
#include "shared/sky_pass.h"
#include "support/gpu_test.hpp"

namespace {

namespace shader = pelagic::shader;
constexpr double kPi = std::numbers::pi;
/// Where less than 0.6 of the sun's light comes through unscattered.
const float kShaded = std::pow(0.6f, pelagic::physics::kCloudDimming);

class CloudsTest : public support::GpuTest {
 protected:
  static constexpr VkExtent2D kExtent{96, 96};

  static pelagic::SkyState stateOf(double cover, double sunElevation = kPi / 2) {
    pelagic::SkyState state;
    state.sunElevation = sunElevation;
    state.haze = 0;
    state.clouds.cover = cover;
    return state;
  }
  /// A narrow view straight up or down; x to the right of the picture, z down (up: mirrored).
  static pelagic::Camera vertical(const glm::dvec3& eye, bool up, double angle = 0.2) {
    pelagic::Camera camera;
    camera.position = eye;
    // Rows: right, up and back of the camera in the world.
    const glm::dvec3 right(1, 0, 0), back(0, up ? -1 : 1, 0), head = glm::cross(back, right);
    camera.rotation = glm::mat3(glm::transpose(glm::dmat3(right, head, back)));
    const float f = static_cast<float>(1 / std::tan(angle / 2));
    camera.projection = glm::mat4(f, 0, 0, 0, 0, -f, 0, 0, 0, 0, 0, -1, 0, 0, 0.1f, 0);
    return camera;
  }

  struct Seen {
    std::vector<float> clouds;  ///< Four a pixel of the clouds' picture.
    VkExtent2D extent;
    std::vector<float> shadow;  ///< One a texel, where the weather holds no clouds down.
    std::vector<float> opener;  ///< The same where it does its most.
    std::vector<float> environment;
    shader::SkyLight light, clearLight;
    /// Mean of a channel over the picture.
    double mean(std::size_t channel) const {
      double sum = 0;
      for (std::size_t i = channel; i < clouds.size(); i += 4) sum += clouds[i];
      return 4 * sum / static_cast<double>(clouds.size());
    }
    double center(std::size_t channel) const {
      return clouds[4 * (extent.height / 2 * extent.width + extent.width / 2) + channel];
    }
    double shadowAt(glm::dvec2 place) const {
      const auto weather = static_cast<double>(pelagic::physics::cloudWeather(glm::vec2(place)));
      place -= glm::floor(place);
      const auto size = static_cast<double>(shader::kCloudCells);
      const auto x = static_cast<std::size_t>(place.x * size), z = static_cast<std::size_t>(place.y * size);
      return std::lerp(static_cast<double>(shadow[z * shader::kCloudCells + x]),
                       static_cast<double>(opener[z * shader::kCloudCells + x]), weather);
    }
  };
  Seen look(const pelagic::SkyState& state, const pelagic::Camera& camera, double time = 0) {
    auto sky = pelagic::Sky::create(device(), state);
    if (!sky) throw std::runtime_error(sky.error().message);
    auto view = pelagic::SkyView::create(*sky, kExtent);
    if (!view) throw std::runtime_error(view.error().message);
    return look(*sky, *view, camera, time);
  }
  Seen look(pelagic::Sky& sky, pelagic::SkyView& view, const pelagic::Camera& camera, double time) {
    gpu().run([&](vk::CommandBuffer commands) {
      sky.record(commands, time);
      view.record(commands, camera);
    });
    const pelagic::SkyMaps maps = view.maps();
    Seen seen;
    seen.clouds = common::readFloats(gpu(), maps.clouds, 0);
    seen.extent = maps.clouds.extent;
    const std::vector<float> shadows = common::readFloats(gpu(), maps.cloudShadow, 0);
    for (std::size_t i = 0; i < shadows.size(); i += 2) {
      seen.shadow.push_back(shadows[i]);
      seen.opener.push_back(shadows[i + 1]);
    }
    seen.environment = common::readFloats(gpu(), maps.environment, 0);
    const auto read = [&](VkBuffer buffer, shader::SkyLight& light) {
      std::memcpy(&light, common::readBuffer(gpu(), buffer, maps.lightSize).data(), sizeof(light));
    };
    read(maps.light, seen.light);
    read(sky.maps().light, seen.clearLight);
    return seen;
  }
};

TEST_F(CloudsTest, CoverIsTheShareOfTheSkyInCloud) {
  for (const double cover : {0.0, 0.15, 0.4, 0.7, 1.0}) {
    const Seen seen = look(stateOf(cover), vertical({0, 3, 0}, true));
    std::size_t shaded = 0;
    for (const float light : seen.shadow) shaded += light < kShaded;
    EXPECT_NEAR(static_cast<double>(shaded) / static_cast<double>(seen.shadow.size()), cover, 0.08) << cover;
    // Where host and composite find the layer; without clouds it is nowhere.
    EXPECT_EQ(seen.light.cloudPlace.w, cover == 0 ? 1e9f : static_cast<float>(stateOf(cover).clouds.base));
    const double top = stateOf(cover).clouds.base + stateOf(cover).clouds.thickness;
    EXPECT_EQ(seen.light.cloudSun.w, cover == 0 ? 1e9f : static_cast<float>(top));
    if (cover == 0) {
      EXPECT_EQ(seen.mean(3), 1);
      EXPECT_EQ(seen.mean(0), 0);
      EXPECT_EQ(seen.light.skyIrradiance, seen.clearLight.skyIrradiance);
    }
  }
}

/// Under a sun in the zenith, what hides it from the sea hides it from the eye there: places, axes and drift agree.
TEST_F(CloudsTest, TheCloudOverheadIsTheOneThatShadesTheSea) {
  pelagic::SkyState state = stateOf(0.25);  // with open sea between fields of clouds
  state.clouds.velocity = {12, -7};
  auto sky = pelagic::Sky::create(device(), state);
  auto view = pelagic::SkyView::create(*sky, kExtent);
  int agree = 0, shaded = 0, tried = 0, open = 0;
  for (int i = 0; i < 150; ++i) {
    const glm::dvec2 eye(4100.0 * (i % 8) - 1e7, 5300.0 * (i / 8));
    const double time = 977.0 * (i % 5);
    const Seen seen = look(*sky, *view, vertical({eye.x, 3, eye.y}, true), time);
    const double shadow = seen.shadowAt({seen.light.cloudPlace.x, seen.light.cloudPlace.y});
    const glm::dvec2 place = (eye - state.clouds.velocity * time) / static_cast<double>(shader::kCloudTile);
    EXPECT_NEAR(std::abs(seen.shadowAt(place) - shadow), 0, 0.35) << "to a texel";
    if (shadow > 0.2 && shadow < 0.9) continue;  // an edge
    ++tried;
    open += seen.light.cloudZenith.w > 0.9f;
    shaded += shadow < 0.5;
    agree += (seen.center(3) < 0.5) == (shadow < 0.5);
  }
  EXPECT_GT(tried, 100);
  EXPECT_GT(open, 10);
  EXPECT_GT(shaded, 10);
  EXPECT_GE(agree, tried - tried / 12) << "but for what is torn out of the edges";
}

TEST_F(CloudsTest, DriftIsTheSameAsAnEyeThatMovesAgainstIt) {
  pelagic::SkyState state = stateOf(0.4, 0.5);
  state.clouds.velocity = {8, 3};
  const Seen later = look(state, vertical({100, 3, 200}, true, 1.2), 60);
  const Seen moved = look(state, vertical({100 - 480, 3, 200 - 180}, true, 1.2), 0);
  double difference = 0;
  for (std::size_t i = 0; i < later.clouds.size(); ++i) difference += std::abs(later.clouds[i] - moved.clouds[i]);
  EXPECT_LT(difference / static_cast<double>(later.clouds.size()), 1e-3);
  const Seen standing = look(state, vertical({100, 3, 200}, true, 1.2), 0);
  difference = 0;
  for (std::size_t i = 3; i < later.clouds.size(); i += 4) difference += std::abs(later.clouds[i] - standing.clouds[i]);
  EXPECT_GT(4 * difference / static_cast<double>(later.clouds.size()), 0.02);
}

/// What tears the edges and their shadows repeats with the altitude as it does along the sea: it is not drawn out to
/// curtains.
TEST_F(CloudsTest, EdgesAreTornInAllDirections) {
  const auto at = [&](double base) {
    pelagic::SkyState state = stateOf(0.5);
    state.clouds.base = base;
    return look(state, vertical({0, base + 3000, 0}, false, 0.5));
  };
  constexpr auto kPeriod = static_cast<double>(shader::kCloudDetailTile);
  const Seen one = at(1000), period = at(1000 + kPeriod), half = at(1000 + 0.5 * kPeriod);
  const auto difference = [](const std::vector<float>& a, const std::vector<float>& b, std::size_t first,
                             std::size_t stride) {
    double sum = 0;
    for (std::size_t i = first; i < a.size(); i += stride) sum += std::abs(a[i] - b[i]);
    return sum;
  };
  EXPECT_GT(difference(one.clouds, half.clouds, 3, 4), 3 * difference(one.clouds, period.clouds, 3, 4));
  EXPECT_GT(difference(one.shadow, half.shadow, 0, 1), 10 * difference(one.shadow, period.shadow, 0, 1));
}

/// A few large clouds, many small ones, and clear places between: over squares of a quarter of the tile, 3.8 km, their
/// share of the sky has a standard deviation of 0.157; without waves of that length in the field 0.098.
TEST_F(CloudsTest, CloudsStandInClusters) {
  constexpr std::uint32_t kCells = shader::kCloudCells;
  const std::vector<float> shadow = look(stateOf(0.3), vertical({0, 3, 0}, true)).shadow;
  constexpr std::uint32_t kSide = kCells / 4;
  double sum = 0, squares = 0;
  for (std::uint32_t square = 0; square < 16; ++square) {
    double shaded = 0;
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
      const std::uint32_t x = square % 4 * kSide + i % kSide, z = square / 4 * kSide + i / kSide;
      shaded += shadow[z * kCells + x] < kShaded;
    }
    shaded /= kSide * kSide;
    sum += shaded / 16;
    squares += shaded * shaded / 16;
  }
  EXPECT_GT(std::sqrt(squares - sum * sum), 0.125);
}

/// However thin and far, a layer that shades the sea is seen.
TEST_F(CloudsTest, AThinLayerIsSeenFromFarBelowAndFarAbove) {
  pelagic::SkyState state = stateOf(1);
  state.clouds.base = 8000;
  state.clouds.thickness = 50;
  EXPECT_LT(look(state, vertical({0, 3, 0}, true)).mean(3), 0.5);
  EXPECT_LT(look(state, vertical({0, 9e4, 0}, false)).mean(3), 0.5);
}

/// A deck reflects and transmits like one: white from above, grey from below, and no more light leaves it than came.
TEST_F(CloudsTest, ADeckKeepsTheEnergyOfTheSun) {
  pelagic::SkyState state = stateOf(1);
  const Seen above = look(state, vertical({0, 6000, 0}, false, 0.6)),
             below = look(state, vertical({0, 3, 0}, true, 0.6));
  EXPECT_LT(above.mean(3), 0.05);
  const double reflected = kPi * above.mean(1) / static_cast<double>(above.light.cloudSun.y);
  EXPECT_GT(reflected, 0.5);
  EXPECT_LT(reflected, 0.9);
  const double transmitted =
      static_cast<double>(below.light.skyIrradiance.y) / static_cast<double>(below.light.cloudSun.y);
  EXPECT_GT(transmitted, 0.05);
  EXPECT_LT(transmitted, 1.05 - reflected);
}

TEST_F(CloudsTest, SkyLightIsTheIrradianceOfTheEnvironment) {
  const Seen seen = look(stateOf(0.5, 0.7), vertical({0, 3, 0}, true));
  const auto size = static_cast<double>(shader::kEnvironmentSize),
             scale = static_cast<double>(shader::kEnvironmentScale);
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < seen.environment.size() / 4; ++i) {
    const glm::dvec2 texel(static_cast<double>(i % shader::kEnvironmentSize),
                           static_cast<double>(i / shader::kEnvironmentSize));
    const glm::dvec2 q = ((texel + 0.5) / size * 2.0 - 1.0) / scale;
    const double s = glm::dot(q, q), area = std::pow(2 / (size * scale), 2);
    const double weight = std::max((1 - s) / (1 + s), 0.0) * 4 / ((1 + s) * (1 + s)) * area;
    for (int c = 0; c < 3; ++c)
      sum[c] += weight * static_cast<double>(seen.environment[4 * i + static_cast<std::size_t>(c)]);
  }
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(static_cast<double>(seen.light.skyIrradiance[c]) / sum[c], 1, 0.01) << c;
  EXPECT_GT(seen.light.skyIrradiance.x, 1.2f * seen.clearLight.skyIrradiance.x) << "white clouds in a blue sky";
}

TEST_F(CloudsTest, FieldsAreRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](const char* name, const auto& set) {
    pelagic::SkyState state;
    set(state.clouds);
    const auto result = pelagic::Sky::create(device(), state);
    ASSERT_FALSE(result) << name;
    std::string field = "SkyState::clouds.";
    field += name;
    EXPECT_NE(result.error().message.find(field), std::string::npos);
  };
  for (const double value : {nan, -0.1, 1.1})
    refused("cover", [&](pelagic::CloudLayer& layer) { layer.cover = value; });
  for (const double value : {nan, 99.0, 8001.0})
    refused("base", [&](pelagic::CloudLayer& layer) { layer.base = value; });
  for (const double value : {nan, 49.0, 4001.0}) {
    refused("thickness", [&](pelagic::CloudLayer& layer) { layer.thickness = value; });
  }
  for (const double value : {nan, -101.0, 101.0}) {
    refused("velocity", [&](pelagic::CloudLayer& layer) { layer.velocity.y = value; });
  }
  const auto sky = pelagic::Sky::create(device(), {});
  ASSERT_TRUE(sky);
  EXPECT_FALSE(pelagic::SkyView::create(*sky, {0, 64}));
}

}  // namespace
