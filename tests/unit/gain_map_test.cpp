#include <gtest/gtest.h>

#include <cmath>
#include <pelagic/query.hpp>
#include <pelagic/wave_sampling.hpp>
#include <waves/gain_field.hpp>

#include "support/even_gain.hpp"

namespace {

using namespace pelagic;

/// 3 x 2 samples, 10 m apart, of two bands.
GainMap smallMap() {
  GainMap map;
  map.origin = {100, -50};
  map.spacing = 10;
  map.width = 3;
  map.height = 2;
  map.bands = 2;
  map.gains = {0, 1, 2, 1, 1, 4, 1, 1, 1, 0.5f, 0.5f, 0.5f};
  return map;
}

WavesInfo infoOf(double wind = 9) {
  WavesInfo info;
  info.sea.windSpeed = wind;
  info.layout = *waveLayout(info.sea, 2, 64);
  return info;
}

TEST(GainMaps, AreLinearBetweenSamplesAndConstantBeyond) {
  const GainMap map = smallMap();
  EXPECT_FLOAT_EQ(gainAt(map, 0, {100, -50}).value, 0);
  EXPECT_FLOAT_EQ(gainAt(map, 0, {115, -50}).value, 1.5f);
  EXPECT_FLOAT_EQ(gainAt(map, 0, {115, -45}).value, 2);
  EXPECT_FLOAT_EQ(gainAt(map, 0, {1e6, 1e6}).value, 4);
  EXPECT_FLOAT_EQ(gainAt(map, 0, {-1e6, -1e6}).value, 0);
  EXPECT_FLOAT_EQ(gainAt(map, 1, {104, -45}).value, 0.75f);
  const Gain slope = gainAt(map, 0, {115, -45});
  EXPECT_FLOAT_EQ(slope.alongX, 0.2f);
  EXPECT_FLOAT_EQ(slope.alongZ, 0.1f);
  EXPECT_EQ(gainAt(map, 0, {1e6, -45}).alongX, 0) << "beyond the edge";
  EXPECT_NE(gainAt(map, 0, {1e6, -45}).alongZ, 0);
  EXPECT_EQ(gainAt({}, 3, {5, 5}).value, 1);
  EXPECT_EQ(largestGain(map), 4);
}

TEST(GainMaps, QueriesFollowTheGainAndItsSlope) {
  WavesInfo info = infoOf();
  info.sea.choppiness = 0;  // so that heights are products of gain and elevation
  SeaQuery plain = *SeaQuery::create(info);
  info.gain = smallMap();
  SeaQuery gained = *SeaQuery::create(info);
  WavesInfo longWaves = info;
  longWaves.gain = {};
  SeaQuery first = *SeaQuery::create(longWaves, 2 * 3.14159265358979 / info.layout.cascades[0].kMax * 1.0001);
  for (SeaQuery* query : {&plain, &gained, &first}) query->setTime(7);
  for (const glm::dvec2 p : {glm::dvec2(103, -47), glm::dvec2(117, -41), glm::dvec2(131, -44), glm::dvec2(0, 0)}) {
    const double low = first.heightAt(p), high = plain.heightAt(p) - low;
    const Gain g0 = gainAt(info.gain, 0, p), g1 = gainAt(info.gain, 1, p);
    const auto gains = [](const Gain& g) { return glm::dvec3(g.value, g.alongX, g.alongZ); };
    const auto slopeOf = [&](const SeaQuery& query) {
      const glm::dvec3 n = query.at(p).normal;
      return glm::dvec2(-n.x / n.y, -n.z / n.y);
    };
    const glm::dvec2 lowSlope = slopeOf(first), highSlope = slopeOf(plain) - lowSlope;
    EXPECT_NEAR(gained.heightAt(p), gains(g0).x * low + gains(g1).x * high, 1e-4);
    const glm::dvec2 expected = gains(g0).x * lowSlope + gains(g1).x * highSlope +
                                low * glm::dvec2(gains(g0).y, gains(g0).z) +
                                high * glm::dvec2(gains(g1).y, gains(g1).z);
    EXPECT_NEAR(slopeOf(gained).x, expected.x, 1e-4);
    EXPECT_NEAR(slopeOf(gained).y, expected.y, 1e-4);
  }
  info.gain.gains.assign(12, 0);
  ASSERT_TRUE(gained.setGain(info.gain));
  EXPECT_EQ(gained.heightAt({110, -44}), 0);
  EXPECT_EQ(gained.at({110, -44}).normal.y, 1);
}

TEST(GainMaps, OneGainEverywhereIsThatOfTheAmplitudes) {
  WavesInfo info = infoOf();
  info.gain = support::evenGain(0.5f);
  SeaQuery gained = *SeaQuery::create(info);
  info.gain = {};
  info.sea.octaveGain.fill(0.5);
  SeaQuery calm = *SeaQuery::create(info);
  gained.setTime(3);
  calm.setTime(3);
  for (int i = 0; i < 50; ++i) {
    const glm::dvec2 p(3.7 * i, -2.1 * i);
    const SurfacePoint a = gained.at(p), b = calm.at(p);
    EXPECT_NEAR(a.position.y, b.position.y, 1e-5);
    EXPECT_NEAR(a.velocity.x, b.velocity.x, 1e-5);
    EXPECT_NEAR(a.acceleration.y, b.acceleration.y, 1e-5);
    EXPECT_NEAR(a.normal.x, b.normal.x, 1e-5);
  }
  EXPECT_TRUE(gained.intersect({0, 30, 0}, {0.3, -1, 0.1}, 100));
}

// Depth, choppiness, gain and octaves at their limits fold the sea over and over: defined, if no sea.
TEST(GainMaps, TheWildestSeaHasAHeightEverywhere) {
  WavesInfo info;
  info.sea.windSpeed = 60;
  info.sea.depth = 0.5;
  info.sea.choppiness = 2;
  info.sea.octaveGain.fill(10);
  info.layout = *waveLayout(info.sea, 3, 64);
  info.gain = support::evenGain(4);
  SeaQuery query = *SeaQuery::create(info);
  query.setTime(100);
  for (int i = 0; i < 3000; ++i) {
    const SurfacePoint point = query.at({1.3 * i, -0.7 * i});
    ASSERT_TRUE(std::isfinite(point.position.y) && std::isfinite(point.normal.x)) << i;
    ASSERT_LT(std::abs(point.position.y), 1e5);
  }
}

TEST(GainMaps, ShadersFindTheirSamples) {
  WaveMaps maps;
  maps.layout = infoOf().layout;
  maps.gainOrigin = {100, -50};
  maps.gainSpacing = 10;
  const auto sampling = waveSampling(maps, {1e8 + 5, 20});
  EXPECT_FLOAT_EQ(sampling.gain.x, 0.1f);
  EXPECT_FLOAT_EQ(sampling.gain.y, static_cast<float>((1e8 - 95) / 10));
  EXPECT_FLOAT_EQ(sampling.gain.z, 7);
}

TEST(GainMaps, BadOnesAreNamed) {
  const auto message = [](auto change) {
    GainMap map = smallMap();
    change(map);
    return validate(map, 2).error().message;
  };
  EXPECT_EQ(message([](GainMap& map) { map.width = 1; }),
            "GainMap::width is 1, it must lie in 2 … 4096, or be 0 for no map");
  EXPECT_EQ(message([](GainMap& map) { map.height = 0; }),
            "GainMap::height is 0, it must lie in 2 … 4096, or be 0 for no map");
  EXPECT_EQ(message([](GainMap& map) { map.bands = 3; }),
            "GainMap::bands is 3, it must be 1 or the number of cascades, 2");
  EXPECT_EQ(message([](GainMap& map) { map.spacing = 0; }), "GainMap::spacing is 0, it must lie in 0.1 … 1e6 m");
  EXPECT_EQ(message([](GainMap& map) { map.origin.y = std::nan(""); }),
            "GainMap::origin.y is nan, it must lie in -1e9 … 1e9 m");
  EXPECT_EQ(message([](GainMap& map) { map.gains.pop_back(); }),
            "GainMap::gains.size() is 11, it must be width x height x bands, 12");
  EXPECT_EQ(message([](GainMap& map) { map.gains[7] = -1; }), "GainMap::gains[7] is -1, it must lie in 0 … 4");
  EXPECT_FALSE(validate(GainMap{.gains = {1}}, 1));
  EXPECT_TRUE(validate(GainMap{}, 4));
  WavesInfo info = infoOf();
  info.gain = smallMap();
  info.gain.gains[0] = HUGE_VALF;
  EXPECT_FALSE(SeaQuery::create(info));
}

}  // namespace
