#include <cmath>
#include <pelagic/query.hpp>

#include "waves_support.hpp"

namespace {

class WavesChangeTest : public support::WavesTest {};

pelagic::WavesInfo steadyInfo() {
  auto info = support::wavesInfo(64, 2, 15);
  info.precision = pelagic::MapPrecision::single;
  info.sea.windSpeed = 5;
  return info;
}

pelagic::SeaState other() {
  pelagic::SeaState sea;
  sea.windSpeed = 14;
  sea.windDirection = 0.8;
  sea.choppiness = 0.7;
  sea.depth = 12;
  return sea;
}

TEST_F(WavesChangeTest, MapsMixBothSeasFrameByFrame) {
  auto info = steadyInfo();
  auto waves = create(info);
  ASSERT_TRUE(waves.setSea(other(), {100, 5}));
  auto before = create(info);
  info.sea = other();
  auto after = create(info);
  for (const double time : {99.5, 100.0, 101.0, 102.5, 104.9, 105.0, 107.0}) {
    record(waves, time);
    record(before, time);
    record(after, time);
    const double t = std::clamp((time - 100) / 5, 0.0, 1.0);
    const double share = t * t * t * (10 + t * (6 * t - 15));
    for (std::uint32_t cascade = 0; cascade < 2; ++cascade) {
      const auto mixed = read(waves.maps(), cascade);
      const auto old = read(before.maps(), cascade);
      const auto fresh = read(after.maps(), cascade);
      for (std::size_t field = 0; field < support::kFields; ++field) {
        std::vector<double> expected(old[field].size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
          expected[i] = (1 - share) * old[field][i] + share * fresh[field][i];
        }
        EXPECT_LT(support::relativeError(mixed[field], expected), 2e-5)
            << support::kFieldNames[field] << " of cascade " << cascade << " at " << time;
      }
    }
    if (t == 0) {
      EXPECT_EQ(waves.maps().windDirection, before.maps().windDirection);
    }
    if (t == 1) {
      EXPECT_EQ(waves.maps().elevationDeviation, after.maps().elevationDeviation);
    }
  }
}

TEST_F(WavesChangeTest, FoamIsAFunctionOfTimeWhileTheSeaChanges) {
  const auto info = steadyInfo();
  auto steps = create(info);
  ASSERT_TRUE(steps.setSea(other(), {20, 5}));
  for (double time = 19; time < 24; time += 0.1) record(steps, time);
  record(steps, 24);
  auto jump = create(info);
  ASSERT_TRUE(jump.setSea(other(), {20, 5}));
  record(jump, 24);
  EXPECT_EQ(common::readFloats(gpu(), steps.maps().foam, 0, 0), common::readFloats(gpu(), jump.maps().foam, 0, 0));
}

TEST_F(WavesChangeTest, QueryAndMapsAgreeInTheMiddle) {
  const auto info = steadyInfo();
  auto waves = create(info);
  auto query = *pelagic::SeaQuery::create(info);
  ASSERT_TRUE(waves.setSea(other(), {100, 5}));
  ASSERT_TRUE(query.setSea(other(), {100, 5}));
  record(waves, 102.2);
  query.setTime(102.2);
  const auto cascade0 = read(waves.maps(), 0)[0];
  const auto cascade1 = read(waves.maps(), 1)[0];
  // The mean height of the lattice over a displaced surface is not a texel: compare where the water of a texel is now.
  const auto dx0 = read(waves.maps(), 0)[1], dz0 = read(waves.maps(), 0)[2];
  const auto dx1 = read(waves.maps(), 1)[1], dz1 = read(waves.maps(), 1)[2];
  const double height = cascade0[0] + cascade1[0];
  EXPECT_NEAR(query.heightAt({dx0[0] + dx1[0], dz0[0] + dz1[0]}), height, 1e-4 * waves.report().gridHeight);
}

TEST_F(WavesChangeTest, BadTransitionsChangeNothing) {
  auto info = steadyInfo();
  auto waves = create(info);
  record(waves, 1);
  EXPECT_FALSE(waves.setSea(other(), {0, HUGE_VAL}));
  record(waves, 2);
  auto fresh = create(info);
  record(fresh, 2);
  EXPECT_EQ(read(waves.maps(), 0)[0], read(fresh.maps(), 0)[0]);
}

}  // namespace
