#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "waves_support.hpp"

namespace {

using pelagic::WavesInfo;

class WavesApiTest : public support::WavesTest {};

TEST_F(WavesApiTest, EveryFieldIsCheckedAndNamed) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  struct Case {
    std::function<void(WavesInfo&)> spoil;
    const char* names;
  };
  const Case cases[] = {
      {[](auto& i) { i.sea.windSpeed = kNan; }, "SeaState::windSpeed"},
      {[](auto& i) { i.layout.size = 96; }, "WaveLayout::size is 96"},
      {[](auto& i) { i.layout.size = 32; }, "WaveLayout::size is 32"},
      {[](auto& i) { i.layout.size = 2048; }, "WaveLayout::size is 2048"},
      {[](auto& i) { i.layout.count = 0; }, "WaveLayout::count is 0"},
      {[](auto& i) { i.layout.count = 9; }, "WaveLayout::count is 9"},
      {[](auto& i) { i.layout.cascades[1].length = kNan; }, "WaveLayout::cascades[1]::length is nan"},
      {[](auto& i) { i.layout.cascades[1].length = 1e5; }, "WaveLayout::cascades[1]::length"},
      {[](auto& i) { i.layout.cascades[1].kMin = 0; }, "WaveLayout::cascades[1]::kMin is 0"},
      {[](auto& i) { i.layout.cascades[0].kMin = kNan; }, "WaveLayout::cascades[0]::kMin is nan"},
      {[](auto& i) { i.layout.cascades[0].kMax = 0; }, "WaveLayout::cascades[0]::kMax is 0"},
      {[](auto& i) { i.layout.cascades[1].kMax = kNan; }, "WaveLayout::cascades[1]::kMax is nan"},
      {[](auto& i) { i.loopPeriod = 0.5; }, "WavesInfo::loopPeriod is 0.5"},
      {[](auto& i) { i.loopPeriod = kNan; }, "WavesInfo::loopPeriod is nan"},
      {[](auto& i) { i.loopPeriod = 1e7; }, "WavesInfo::loopPeriod"},
      {[](auto& i) { i.layout.cascades[1].kMax = 9e3; }, "WavesInfo::loopPeriod"},
      {[](auto& i) { i.precision = static_cast<pelagic::MapPrecision>(7); }, "WavesInfo::precision is 7"},
      {[](auto& i) { i.framesInFlight = 0; }, "WavesInfo::framesInFlight is 0"},
      {[](auto& i) { i.framesInFlight = 5; }, "WavesInfo::framesInFlight is 5"},
  };
  for (const auto& [spoil, names] : cases) {
    auto info = support::wavesInfo(64, 2);
    spoil(info);
    const auto waves = pelagic::Waves::create(device(), info);
    ASSERT_FALSE(waves) << names;
    EXPECT_EQ(waves.error().code, pelagic::ErrorCode::invalidArgument);
    EXPECT_NE(waves.error().message.find(names), std::string::npos) << waves.error().message;
    EXPECT_NE(waves.error().message.find("it must"), std::string::npos) << waves.error().message;
  }
}

TEST_F(WavesApiTest, TheTwoDisplacementMapsTakeTurns) {
  auto waves = create(support::wavesInfo(64, 1));
  record(waves, 1);
  const auto first = waves.maps();
  EXPECT_NE(first.displacement.image, first.previousDisplacement.image);
  const auto shown = common::readFloats(gpu(), first.displacement, 0, 0);
  EXPECT_EQ(shown, common::readFloats(gpu(), first.previousDisplacement, 0, 0)) << "nothing moved before";
  record(waves, 1.5);
  const auto second = waves.maps();
  EXPECT_EQ(second.previousDisplacement.view, first.displacement.view);
  EXPECT_EQ(second.displacement.view, first.previousDisplacement.view);
  EXPECT_EQ(shown, common::readFloats(gpu(), second.previousDisplacement, 0, 0));
  EXPECT_NE(shown, common::readFloats(gpu(), second.displacement, 0, 0));
  EXPECT_EQ(first.gradient.view, second.gradient.view);
}

TEST_F(WavesApiTest, ANewSeaComesWithTheNextRecord) {
  auto info = support::wavesInfo(64, 2, 15);
  auto waves = create(info);
  record(waves, 9);
  const double stormy = waves.maps().elevationDeviation;
  auto calm = info.sea;
  calm.windSpeed = 5;
  calm.windDirection = 2;
  ASSERT_TRUE(waves.setSea(calm));
  EXPECT_EQ(waves.maps().elevationDeviation, stormy) << "the maps still show the old sea";
  EXPECT_LT(waves.report().gridHeight, 4 * stormy);
  record(waves, 9);
  EXPECT_LT(waves.maps().elevationDeviation, stormy);
  EXPECT_EQ(waves.maps().windDirection, 2);
  info.sea = calm;
  auto fresh = create(info);
  record(fresh, 9);
  EXPECT_EQ(read(waves.maps(), 1)[0], read(fresh.maps(), 1)[0]);
  EXPECT_EQ(common::readFloats(gpu(), waves.maps().foam, 0, 0), common::readFloats(gpu(), fresh.maps().foam, 0, 0));

  calm.windSpeed = -1;
  EXPECT_FALSE(waves.setSea(calm));
  record(waves, 9);
  EXPECT_EQ(read(waves.maps(), 1)[0], read(fresh.maps(), 1)[0]) << "a rejected sea changes nothing";
}

TEST_F(WavesApiTest, ReportAgreesWithTheSpectrum) {
  const auto info = support::wavesInfo(256, 4, 10);
  auto waves = create(info);
  const auto report = waves.report();
  EXPECT_NEAR(report.gridHeight / report.targetHeight, 1, 0.02);
  EXPECT_DOUBLE_EQ(report.targetHeight, pelagic::significantWaveHeight(info.sea));
  EXPECT_DOUBLE_EQ(report.whitecaps, pelagic::whitecapFraction(10));
  EXPECT_GE(report.grid.upwind + report.unresolved.upwind, report.target.upwind * 0.999);
  EXPECT_GE(report.grid.crosswind + report.unresolved.crosswind, report.target.crosswind * 0.999);
  const double highest = info.layout.cascades[3].kMax;
  const auto mss = pelagic::slopeVariance(info.sea, 0, highest);
  EXPECT_NEAR(report.grid.upwind / mss.upwind, 1, 0.02);
  EXPECT_NEAR(report.grid.crosswind / mss.crosswind, 1, 0.02);
  EXPECT_LT(report.frequencyError, 1e-5);
  double modes = 0;
  for (std::uint32_t c = 0; c < 4; ++c) {
    const auto variance = waves.modeVariance(c);
    modes = std::accumulate(variance.begin(), variance.end(), modes);
  }
  EXPECT_NEAR(4 * std::sqrt(modes), report.gridHeight, 1e-9);
}

TEST_F(WavesApiTest, AShortLoopBendsFrequenciesByAKnownAmount) {
  auto info = support::wavesInfo(64, 1, 10);
  info.loopPeriod = 60;
  const auto report = create(info).report();
  const double slowest =
      pelagic::angularFrequency(2 * 3.14159265358979 / info.layout.cascades[0].length, info.sea.depth);
  EXPECT_GT(report.frequencyError, 0.001);
  EXPECT_LE(report.frequencyError, 3.14159265358979 / (60 * slowest));
}

TEST_F(WavesApiTest, ManyFramesInFlightMayChangeTheSea) {
  auto info = support::wavesInfo(64, 2, 8);
  info.framesInFlight = 3;
  auto waves = create(info);
  auto sea = info.sea;
  gpu().run([&](vk::CommandBuffer commands) {
    for (int frame = 0; frame < 3; ++frame) {
      sea.windSpeed = 6 + frame;
      ASSERT_TRUE(waves.setSea(sea));
      waves.record(commands, 0.1 * frame);
    }
  });
  info.sea = sea;
  auto fresh = create(info);
  record(fresh, 0.2);
  EXPECT_EQ(read(waves.maps(), 0)[0], read(fresh.maps(), 0)[0]);
}

}  // namespace
