#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <physics/whitecaps.glsl>
#include <waves/grid_sea.hpp>
#include <waves/whitecaps.hpp>

namespace {

using pelagic::JacobianSpread;

const std::array<JacobianSpread, 2> kBands{{{0.1, 0.2, 0.2}, {0.08, 0.3, 0.25}}};

TEST(Whitecaps, NormalDistributionIsErfc) {
  for (float x = -5; x <= 5; x += 0.25f) {
    const double exact = 0.5 * std::erfc(-static_cast<double>(x) / std::sqrt(2.0));
    EXPECT_NEAR(pelagic::shader::normalDistribution(x), exact, 2e-4) << x;
  }
}

TEST(Whitecaps, BreakIsHalfAtTheThreshold) {
  using pelagic::shader::breakingCoverage;
  EXPECT_NEAR(breakingCoverage(0.7f, 0.7f, 10), 0.5f, 1e-6f);
  EXPECT_EQ(breakingCoverage(0.75f, 0.7f, 10), 0.0f);
  EXPECT_EQ(breakingCoverage(0.65f, 0.7f, 10), 1.0f);
  EXPECT_NEAR(breakingCoverage(0.69f, 0.7f, 10) + breakingCoverage(0.71f, 0.7f, 10), 1.0f, 1e-5f);
}

TEST(Whitecaps, ThresholdGivesTheCoverageAskedFor) {
  double before = -1e9;
  for (const double coverage : {1e-5, 1e-3, 0.02, 0.2, 0.6}) {
    const double threshold = pelagic::foldThreshold(kBands, coverage);
    EXPECT_NEAR(pelagic::expectedFoam(kBands, threshold), coverage, 1e-6 + 1e-3 * coverage);
    EXPECT_GT(threshold, before) << "more foam breaks earlier";
    before = threshold;
  }
}

/// One wave s = sqrt(2) deviation cos(wt + phase) with a Rayleigh amplitude has the statistics of a Gaussian process of
/// one frequency: its foam is found by brute force.
TEST(Whitecaps, ExpectedFoamOfOneFrequencyIsThatOfItsCycles) {
  constexpr double kDeviation = 0.12, kFrequency = 0.9;
  const std::array<JacobianSpread, 1> band{{{kDeviation, kDeviation * kFrequency, 0}}};
  const double threshold = 0.65;
  const double inverse = pelagic::inverseSpread(band, 0);
  double expected = 0;
  constexpr int kAmplitudes = 400, kPhases = 200, kPast = 200;
  for (int a = 0; a < kAmplitudes; ++a) {
    const double amplitude = kDeviation * std::sqrt(-2 * std::log((a + 0.5) / kAmplitudes));
    for (int p = 0; p < kPhases; ++p) {
      double foam = 0;
      for (int s = 0; s < kPast; ++s) {
        const double age = pelagic::kFoamLifetime * s / kPast;
        const double jacobian = 1 + amplitude * std::cos(2 * 3.14159265358979 * p / kPhases - kFrequency * age);
        const double coverage = pelagic::shader::breakingCoverage(
            static_cast<float>(jacobian), static_cast<float>(threshold), static_cast<float>(inverse));
        foam = std::max(foam, coverage - age / pelagic::kFoamLifetime);
      }
      expected += foam / (kAmplitudes * kPhases);
    }
  }
  // One frequency returns within the lifetime to the same place: its crossings are grouped like no sea's.
  EXPECT_NEAR(pelagic::expectedFoam(band, threshold) / expected, 0.9, 0.2);
}

TEST(Whitecaps, JacobianSpreadIsTheSumOverModes) {
  pelagic::SeaState sea;
  sea.windSpeed = 10;
  const auto layout = pelagic::waveLayout(sea, 2, 64).value();
  const auto modes = pelagic::makeModes(sea, layout, 1, 4194304);
  const auto moments = pelagic::momentsOf(modes, layout.cascades[1], 64);
  const auto spread = pelagic::jacobianSpread(modes, layout.cascades[1], 64, 4194304);
  // Deep water and choppiness 1: D = i k/|k| h, so that s = -|k| h has the variance of the slopes.
  EXPECT_NEAR(spread.deviation * spread.deviation / (moments.slopes.x + moments.slopes.y), 1, 1e-4);
  // Its frequency is one of the band's.
  EXPECT_GT(spread.rate / spread.deviation, pelagic::angularFrequency(layout.cascades[1].kMin, sea.depth));
  EXPECT_LT(spread.rate / spread.deviation, pelagic::angularFrequency(layout.cascades[1].kMax, sea.depth));
  EXPECT_GT(spread.curvature, 0);
  EXPECT_LE(spread.curvature, 0.25);
}

TEST(Whitecaps, AStillSeaNeverBreaks) {
  const std::array<JacobianSpread, 2> still{};
  const double threshold = pelagic::foldThreshold(still, 0.1);
  EXPECT_EQ(pelagic::shader::breakingCoverage(1, static_cast<float>(threshold),
                                              static_cast<float>(pelagic::inverseSpread(still, 0))),
            0.0f);
}

TEST(WaveLayout, EverySizeAndCountFitsTheLongestLoop) {
  for (const double wind : {0.1, 8.0, 60.0}) {
    for (const std::uint32_t size : {64u, 256u, 1024u}) {
      for (const std::uint32_t count : {1u, 4u, 8u}) {
        pelagic::WavesInfo info;
        info.sea.windSpeed = wind;
        info.layout = pelagic::waveLayout(info.sea, count, size).value();
        const auto valid = pelagic::validate(info);
        EXPECT_TRUE(valid) << wind << " m/s, " << count << " x " << size << ": " << valid.error().message;
        for (std::uint32_t c = 1; c < count; ++c) {
          const auto& cascade = info.layout.cascades[c];
          EXPECT_GE(cascade.kMin * cascade.length / 6.283185307, 15.99);
        }
      }
    }
  }
}

}  // namespace
