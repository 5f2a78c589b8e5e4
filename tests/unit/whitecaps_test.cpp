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
  // So that a sea without foam and one with it mix.
  const double none = pelagic::foldThreshold(kBands, 0);
  EXPECT_GT(none, -20);
  EXPECT_EQ(pelagic::expectedFoam(kBands, none), 0);
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

TEST(Whitecaps, OtherBandsSoftenTheEdges) {
  const std::array<JacobianSpread, 3> bands{{{0.3, 1, 0}, {0.4, 1, 0}, {1.2, 1, 0}}};
  EXPECT_NEAR(pelagic::inverseSpread(bands, 2), 1 / 0.5, 1e-12);
  EXPECT_NEAR(pelagic::inverseSpread(bands, 1), 1 / std::hypot(0.3, 1.2), 1e-12);
  EXPECT_NEAR(pelagic::inverseSpread(std::span(bands).first(1), 0), 4 / 0.3, 1e-12);  // alone: a quarter of its own
}

TEST(Whitecaps, ExpectedFoamIsTheShareThatBreaksAndWhatFades) {
  // Water breaks where a normal Jacobian is below 1 - x deviations, a share Phi(-x); its edge is a sixteenth of a
  // deviation wide. Rice (1944): that begins rate / (2 pi deviation) exp(-x^2 / 2) times a second, and the foam of each
  // time fades linearly. expectedFoam lets 0.85 of it overlap independently.
  constexpr double kDeviation = 0.1, kTwoPi = 6.28318530717959;
  for (const double x : {0.0, 0.5, 1.0}) {
    for (const double frequency : {0.0, 0.4}) {
      const std::array<JacobianSpread, 1> band{{{kDeviation, frequency * kDeviation, 0}}};
      const double breaking = 0.5 * std::erfc(x / std::sqrt(2.0));
      const double fading = 0.5 * pelagic::kFoamLifetime * frequency / kTwoPi * std::exp(-0.5 * x * x);
      const double expected = 1 - std::exp(-0.85 * (breaking + fading));
      EXPECT_NEAR(pelagic::expectedFoam(band, 1 - x * kDeviation) / expected, 1, 0.02) << x << ' ' << frequency;
    }
  }
}

TEST(Whitecaps, FoamDeclinesWithTheGainAsTheTailOfTheNormalDistribution) {
  const std::array<JacobianSpread, 2> bands{{{0.12, 0.1, 0.1}, {0.2, 0.4, 0.1}}};
  for (const double cover : {0.002, 0.02}) {
    const double threshold = pelagic::foldThreshold(bands, cover);
    const double w = pelagic::foamDecline(bands, threshold);
    for (const double gain : {0.7, 0.8, 0.9, 1.1}) {
      std::array<JacobianSpread, 2> scaled = bands;
      for (JacobianSpread& band : scaled) {
        band.deviation *= gain;
        band.rate *= gain;
      }
      const double foam = pelagic::expectedFoam(scaled, threshold) / cover;
      EXPECT_NEAR(std::exp(-w * (1 / (gain * gain) - 1)) / foam, 1, gain == 0.8 ? 0.01 : 0.25) << cover << ' ' << gain;
    }
  }
  EXPECT_EQ(pelagic::foamDecline({}, 1), 0);
  // All foam: calmer is not less.
  for (const double cover : {0.5, 0.9, 0.999}) {
    EXPECT_GE(pelagic::foamDecline(bands, pelagic::foldThreshold(bands, cover)), 0) << cover;
  }
}

/// Modes of a cascade 2 pi long, all of one stretch k^2 chop = 1.
struct Wave {
  int x, z;
  double variance;
  std::uint32_t cycles;
};
JacobianSpread spreadOf(std::initializer_list<Wave> waves, double loopPeriod) {
  constexpr std::uint32_t kSize = 64;
  pelagic::CascadeModes modes;
  modes.variance.assign(kSize * kSize, 0);
  modes.constants.assign(kSize * kSize, {});
  for (const Wave& wave : waves) {
    const std::size_t index = static_cast<std::size_t>((wave.z + 64) % 64 * 64 + (wave.x + 64) % 64);
    modes.variance[index] = wave.variance;
    modes.constants[index] = {wave.cycles,
                              glm::vec2(0.6f, -0.8f) / static_cast<float>(wave.x * wave.x + wave.z * wave.z)};
  }
  return pelagic::jacobianSpread(modes, {2 * 3.14159265358979, 0, 100}, kSize, loopPeriod);
}

TEST(Whitecaps, CurvatureIsThatOfCrossingWaves) {
  // Water that waves of one direction squeeze has a Jacobian linear in s, whatever the direction.
  EXPECT_NEAR(spreadOf({{3, 4, 0.01, 5}}, 100).curvature, 0, 1e-6);
  EXPECT_NEAR(spreadOf({{6, -3, 0.01, 5}}, 100).curvature, 0, 1e-6);
  // Of two that cross at right angles, shares p and 1 - p of the variance, J = (1 + a)(1 + b): E[ab | a + b = s] is
  // p (1 - p) (s^2 - deviation^2).
  const JacobianSpread crossing = spreadOf({{5, 0, 0.003, 20}, {0, 5, 0.001, 10}}, 100);
  EXPECT_NEAR(crossing.curvature, 3.0 / 16, 1e-6);
  EXPECT_NEAR(spreadOf({{3, 4, 0.003, 20}, {4, -3, 0.001, 10}}, 100).curvature, 3.0 / 16, 1e-6);
  // Variances of s and of its rate: sums over the waves.
  constexpr double kTwoPi = 6.28318530717959;
  EXPECT_NEAR(crossing.deviation, std::sqrt(0.004), 1e-7);
  EXPECT_NEAR(crossing.rate, kTwoPi * std::sqrt(0.003 * 0.2 * 0.2 + 0.001 * 0.1 * 0.1), 1e-7);
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
