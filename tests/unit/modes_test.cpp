#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "waves/closure.hpp"
#include "waves/grid_sea.hpp"

namespace {

using namespace pelagic;
constexpr double kTwoPi = 2 * std::numbers::pi;

WaveLayout layoutOf(const SeaState& sea, std::uint32_t count = 4, std::uint32_t size = 256) {
  return waveLayout(sea, count, size).value();
}

TEST(Layout, PartitionsTheWaveNumbers) {
  const SeaState sea;
  for (const std::uint32_t size : {64u, 256u, 1024u}) {
    const WaveLayout layout = layoutOf(sea, 4, size);
    EXPECT_NEAR(layout.cascades[0].length, kPatchWavelengths * longestPeakWavelength(sea), 1e-9);
    for (std::uint32_t c = 0; c < 4; ++c) {
      const Cascade& patch = layout.cascades[c];
      const double mode = kTwoPi / patch.length;
      EXPECT_NEAR(patch.kMax / mode, 0.7 * size / 2, 1e-9 * size);
      if (c == 0) continue;
      EXPECT_EQ(patch.kMin, layout.cascades[c - 1].kMax);
      EXPECT_GE(patch.kMin / mode, 16);
    }
  }
}

// What repeats at the length of a patch is its share of the variance: with a span of 2 km and 512 samples only 7 % of
// the default sea repeats sooner.
TEST(Layout, ASpanKeepsTheSeaFromRepeating) {
  const SeaState sea;
  const double all = elevationVariance(sea, 0, 1e4);
  double before = 0;
  for (const std::uint32_t size : {256u, 512u, 1024u}) {
    const WaveLayout layout = waveLayout(sea, 4, size, 2000).value();
    EXPECT_DOUBLE_EQ(layout.cascades[0].length, 2000);
    const double share = elevationVariance(sea, 0, layout.cascades[0].kMax) / all;
    EXPECT_GT(share, before);
    before = share;
    EXPECT_NEAR(share, size == 256 ? 0.76 : size == 512 ? 0.94 : 0.985, 0.04) << size;
  }
  EXPECT_GT(before, 0.95) << "less than 0.05 repeats within 2 km";
  EXPECT_EQ(waveLayout(sea, 4, 256, 10).value().cascades[0].length, waveLayout(sea).value().cascades[0].length);
}

TEST(Layout, RefusesWhatItCannotHold) {
  EXPECT_EQ(waveLayout({}, 4, 256, -1).error().message,
            "the span of the layout is -1.000000 m, it must lie in 0 … 100000 m");
  EXPECT_EQ(waveLayout({}, 0).error().message, "the number of cascades is 0, it must lie in 1 … 8");
  EXPECT_EQ(waveLayout({}, 4, 200).error().message, "the cascade size is 200, it must be a power of two in 64 … 1024");
}

TEST(Modes, CarryTheSpectrumsEnergy) {
  SeaState sea;
  sea.windDirection = 0.4;
  const WaveLayout layout = layoutOf(sea);
  const double dk = kTwoPi / layout.cascades[1].length;
  const CascadeModes modes = makeModes(sea, layout, 1, 4194304);
  const int mx = 20, mz = -30;
  const double psi = waveNumberSpectrum(sea, mx * dk, mz * dk);
  const double opposite = waveNumberSpectrum(sea, -mx * dk, -mz * dk);
  const double variance = modes.variance[(256 + mz) * 256 + mx];
  EXPECT_NEAR(variance, 0.5 * (psi + opposite) * dk * dk, 1e-12 * variance);
}

TEST(Modes, MoveWaterSidewaysAsFarAsUpwardInDeepWaterAndFartherInShallow) {
  SeaState sea;
  sea.choppiness = 0.7;
  sea.asymmetry = 2;  // which turns no length
  const auto ratioOf = [&] {
    const WaveLayout layout = layoutOf(sea, 2, 64);
    const CascadeMoments moments = momentsOf(makeModes(sea, layout, 0, 4194304), layout.cascades[0], layout.size);
    return std::sqrt(moments.horizontal / moments.elevation);
  };
  EXPECT_NEAR(ratioOf(), 0.7, 1e-6);
  // Every wave of the cascade is longer than L / 22.4, so coth(k h) exceeds that of the shortest.
  sea.depth = 2;
  const WaveLayout layout = layoutOf(sea, 2, 64);
  EXPECT_GT(ratioOf(), 0.7 / std::tanh(layout.cascades[0].kMax * sea.depth));
}

/// Seas of every spectrum and spreading.
std::vector<SeaState> everySea() {
  std::vector<SeaState> seas(7);
  seas[0].windSpeed = 11;
  seas[0].swell.push_back({1.2, 11, 1.0, 30});
  seas[1].spectrum = Spectrum::elfouhaily;
  seas[1].spreading = Spreading::elfouhaily;
  seas[2].spectrum = Spectrum::table;
  seas[2].spreading = Spreading::donelanBanner;
  seas[2].table = {{0.05, 0.09, 0.15, 0.3, 0.5}, {}, {0, 12, 4, 0.5, 0.05}};
  seas[3].spectrum = Spectrum::tma;
  seas[3].depth = 7;
  seas[3].spreading = Spreading::cos2;
  seas[3].swellSharpening = 0.4;
  seas[4].spectrum = Spectrum::piersonMoskowitz;
  seas[4].spreading = Spreading::mitsuyasu;
  seas[5].spectrum = Spectrum::phillips;
  seas[5].octaveGain[7] = 0.5;
  seas[6].spectrum = Spectrum::table;
  seas[6].table = {{0.06, 0.1, 0.2}, {0, 1, 2, 3, 4, 5, 6}, std::vector<double>(21, 0.5)};
  return seas;
}

TEST(Modes, SumToTheSpectrumsIntegrals) {
  for (const SeaState& sea : everySea()) {
    ASSERT_TRUE(validate(sea));
    const WaveLayout layout = layoutOf(sea);
    double elevation = 0, slopes = 0;
    for (std::uint32_t c = 0; c < layout.count; ++c) {
      const CascadeMoments moments = momentsOf(makeModes(sea, layout, c, 4194304), layout.cascades[c], layout.size);
      elevation += moments.elevation;
      slopes += moments.slopes.x + moments.slopes.y;
    }
    const double kMax = std::min(layout.cascades[layout.count - 1].kMax, shortestWaveNumber(sea));
    const int kind = static_cast<int>(sea.spectrum);
    EXPECT_NEAR(elevation / elevationVariance(sea, 0, kMax), 1, 0.01) << "spectrum " << kind;
    const SlopeVariance expected = slopeVariance(sea, 0, kMax);
    EXPECT_NEAR(slopes / (expected.upwind + expected.crosswind), 1, 0.01) << "spectrum " << kind;
  }
}

TEST(GridSea, SaysWhenThePatchesAreTooShort) {
  WavesInfo info;
  info.layout = layoutOf(info.sea, 2, 128);
  const SeaReport fits = makeGridSea(info.sea, info).report;
  EXPECT_NEAR(fits.wavelengthsInPatch, kPatchWavelengths, 1e-9);
  EXPECT_NEAR(fits.gridHeight / fits.targetHeight, 1, 0.03);  // two small cascades end at 0.6 m
  SeaState storm;
  storm.windSpeed = 30;
  storm.fetch = 1e7;
  const SeaReport tooShort = makeGridSea(storm, info).report;
  EXPECT_NEAR(tooShort.wavelengthsInPatch,
              kPatchWavelengths * longestPeakWavelength(info.sea) / longestPeakWavelength(storm), 1e-9);
  EXPECT_LT(tooShort.wavelengthsInPatch, 1);
}

TEST(GridSea, ReportsSlopesAlongTheWind) {
  WavesInfo info;
  info.sea.windDirection = 0.6;
  info.layout = layoutOf(info.sea, 3, 128);
  const SeaReport report = makeGridSea(info.sea, info).report;
  const double kMax = info.layout.cascades[2].kMax;
  const SlopeVariance expected = slopeVariance(info.sea, 0, kMax);
  ASSERT_GT(expected.upwind, 1.1 * expected.crosswind);
  EXPECT_NEAR(report.grid.upwind / expected.upwind, 1, 0.01);
  EXPECT_NEAR(report.grid.crosswind / expected.crosswind, 1, 0.01);
  const SlopeVariance measured = coxMunkSlopes(8);
  EXPECT_NEAR(report.unresolved.upwind, measured.upwind - report.grid.upwind, 1e-12);
  EXPECT_NEAR(report.unresolved.crosswind, measured.crosswind - report.grid.crosswind, 1e-12);
}

TEST(GridSea, SaysHowFarALoopBendsFrequencies) {
  // Whole cycles in a loop T bend the frequency of a wave by pi / (T w) at most; the worst comes near it at long waves.
  WavesInfo info;
  info.layout = layoutOf(info.sea, 1, 64);
  info.loopPeriod = 30;
  const double dk = kTwoPi / info.layout.cascades[0].length;
  double worst = 0;
  for (int x = 0; x < 32; ++x) {
    for (int z = 0; z < 32; ++z) {
      const double k = dk * std::hypot(x, z);
      if (k == 0 || k >= info.layout.cascades[0].kMax) continue;
      const double cycles = angularFrequency(k, info.sea.depth) * 30 / kTwoPi;
      worst = std::max(worst, std::abs(std::max(1.0, std::round(cycles)) / cycles - 1));
    }
  }
  ASSERT_GT(worst, 0.01);
  EXPECT_NEAR(makeGridSea(info.sea, info).report.frequencyError, worst, 1e-9);
}

TEST(GridSea, KeepsFoamOfWavesLongerThanFourMetres) {
  // A band counts by its middle, the geometric mean of its edges: pi/2 rad/m is a wave of four metres.
  WaveLayout layout;
  layout.count = 3;
  layout.cascades[0] = {100, 0, 1};
  layout.cascades[1] = {10, 1, 0.99 * kTwoPi * kTwoPi / 16};
  layout.cascades[2] = {1, layout.cascades[1].kMax, 300};
  EXPECT_EQ(foamCascades(layout), 2u);
  layout.cascades[1].kMax = 1.01 * kTwoPi * kTwoPi / 16;
  layout.cascades[2].kMin = layout.cascades[1].kMax;
  EXPECT_EQ(foamCascades(layout), 1u);
}

TEST(Modes, AmplitudesAreGaussianWithTheExpectedVariance) {
  const SeaState sea;
  const WaveLayout layout = layoutOf(sea);
  const CascadeModes modes = makeModes(sea, layout, 2, 4194304);
  double ratio = 0, fourth = 0;
  int count = 0;
  for (std::size_t i = 0; i < modes.variance.size(); ++i) {
    if (modes.variance[i] <= 0) continue;
    // Forward and backward parts are independent: |h|^2 at t = 0 is chi-squared with two degrees of freedom.
    const glm::dvec4 a(modes.amplitude[i]);
    const double power = std::pow(a.x + a.z, 2) + std::pow(a.y + a.w, 2);
    ratio += power / modes.variance[i];
    fourth += std::pow(power / modes.variance[i], 2);
    ++count;
  }
  // Pairs (k, -k) are the same value: count / 2 independent ones, standard error 1/sqrt(count/2).
  EXPECT_GT(count, 20000);
  EXPECT_NEAR(ratio / count, 1, 5 / std::sqrt(0.5 * count));
  EXPECT_NEAR(fourth / count, 2, 25 / std::sqrt(0.5 * count));
}

TEST(Modes, AreHermitianSoThatTheSeaIsReal) {
  const SeaState sea;
  const WaveLayout layout = layoutOf(sea);
  const CascadeModes modes = makeModes(sea, layout, 0, 4194304);
  for (const auto& [x, z] : {std::pair{3u, 250u}, {40u, 5u}, {255u, 255u}, {17u, 0u}}) {
    const glm::vec4 a = modes.amplitude[z * 256 + x];
    const glm::vec4 b = modes.amplitude[((256 - z) % 256) * 256 + (256 - x) % 256];
    EXPECT_EQ(a.x, b.z);
    EXPECT_EQ(a.y, -b.w);
  }
}

TEST(Modes, DependOnSeedCascadeAndModeAlone) {
  SeaState sea;
  const WaveLayout layout = layoutOf(sea, 2, 128);
  const CascadeModes first = makeModes(sea, layout, 0, 4194304);
  const CascadeModes again = makeModes(sea, layout, 0, 4194304);
  EXPECT_EQ(first.amplitude, again.amplitude);
  // Another wind only re-weights: the direction of every complex amplitude stays.
  SeaState stronger = sea;
  stronger.windSpeed = 12;
  const CascadeModes other = makeModes(stronger, layout, 0, 4194304);
  const std::size_t index = 5 * 128 + 9;
  EXPECT_NEAR(std::atan2(first.amplitude[index].y, first.amplitude[index].x),
              std::atan2(other.amplitude[index].y, other.amplitude[index].x), 1e-6);
  sea.seed = 2;
  EXPECT_NE(first.amplitude[index], makeModes(sea, layout, 0, 4194304).amplitude[index]);
}

TEST(Modes, LeaveTheMeanAndTheNyquistModesEmpty) {
  const SeaState sea;
  const WaveLayout layout = layoutOf(sea, 1, 64);
  const CascadeModes modes = makeModes(sea, layout, 0, 4194304);
  EXPECT_EQ(modes.amplitude[0], glm::vec4(0));
  for (std::uint32_t i = 0; i < 64; ++i) {
    EXPECT_EQ(modes.amplitude[32 * 64 + i], glm::vec4(0));
    EXPECT_EQ(modes.amplitude[i * 64 + 32], glm::vec4(0));
  }
}

TEST(Modes, TurnAWholeNumberOfTimesPerLoop) {
  SeaState sea;
  sea.depth = 15;
  const WaveLayout layout = layoutOf(sea, 2, 128);
  for (const double period : {4194304.0, 33.7}) {
    const CascadeModes modes = makeModes(sea, layout, 0, period);
    const double k = kTwoPi / layout.cascades[0].length * 5;
    const double exact = angularFrequency(k, 15) * period / kTwoPi;
    EXPECT_NEAR(modes.constants[5].cycles, exact, 0.5);
    EXPECT_NEAR(modes.constants[5].chop.x, 1 / (k * std::tanh(k * 15)), 1e-6 / k);
    EXPECT_EQ(modes.constants[5].chop.y, 0) << "no lean unless asked for";
  }
}

TEST(LoopFraction, IsExactForLongTimes) {
  EXPECT_EQ(loopFraction(0, 4194304), 0u);
  EXPECT_EQ(loopFraction(4194304.0 * 3, 4194304), 0u);
  EXPECT_EQ(loopFraction(4194304.0 * 1024 + 2097152, 4194304), 0x8000000000000000u);
  EXPECT_EQ(loopFraction(-1048576, 4194304), 0xc000000000000000u);
  const long double exact = std::fmod(2592000.0L, 33.7L) / 33.7L;
  EXPECT_NEAR(static_cast<double>(loopFraction(2592000, 33.7)) * 0x1p-64, static_cast<double>(exact), 1e-10);
}

}  // namespace
