#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <pelagic/query.hpp>
#include <set>
#include <waves/trochoids.hpp>

#include "lattice.hpp"

namespace {

using namespace pelagic;
constexpr double kTwoPi = 2 * std::numbers::pi;

/// A sea of trochoids alone.
SeaState still() {
  SeaState sea;
  sea.octaveGain.fill(0);
  return sea;
}

/// Twelve of the longest waves fit the longest patch, which no warp bends.
WavesInfo infoOf(const SeaState& sea, std::uint32_t count = 1, std::uint32_t size = 128) {
  WavesInfo info;
  info.sea = sea;
  info.layout = *waveLayout(sea, count, size, 12 * longestPeakWavelength(sea));
  info.warp = 0;
  return info;
}

SeaMoments momentsOf(const WavesInfo& info) { return makeGridSea(info.sea, info).moments; }

/// Points along the wave, exactly where texels of the lattice are displaced to.
struct Profile {
  std::vector<double> x, height, slope;
  double length = 0;
};

Profile profileOf(const WavesInfo& info, double time) {
  const CpuLattice lattice = unit::latticeOf(info, 0, time);
  Profile profile;
  profile.length = info.layout.cascades[0].length;
  for (std::uint32_t i = 0; i < info.layout.size; ++i) {
    const glm::dvec4 d(lattice.texels().displacement[i]);
    const glm::dvec4 g(lattice.texels().gradient[i]);
    profile.x.push_back(profile.length * i / info.layout.size + d.x);
    profile.height.push_back(d.y);
    profile.slope.push_back(g.x / (1 + g.z));
  }
  return profile;
}

/// Mean over the displaced surface by the trapezium rule.
template <class F>
double meanOver(const Profile& profile, F value) {
  double sum = 0;
  const std::size_t n = profile.x.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double next = i + 1 < n ? profile.x[i + 1] : profile.x[0] + profile.length;
    sum += 0.5 * (value(i) + value((i + 1) % n)) * (next - profile.x[i]);
  }
  return sum / profile.length;
}

TEST(Trochoids, AreGerstnersWave) {
  SeaState sea = still();
  sea.trochoids = {{2, 80, 0, 1, 0.4}};
  const WavesInfo info = infoOf(sea);
  const Trochoid wave = trochoidsOnGrid(sea, info.layout, 0).waves.at(0).wave;
  EXPECT_NEAR(wave.wavelength, 80, 1e-9);
  const double k = kTwoPi / wave.wavelength;
  const double w = angularFrequency(k, sea.depth);
  for (const double time : {0.0, 3.7, 86400.0}) {
    const Profile profile = profileOf(info, time);
    for (std::size_t i = 0; i < profile.x.size(); ++i) {
      const double x = profile.length * static_cast<double>(i) / static_cast<double>(profile.x.size());
      const double phase = k * x - w * time + wave.phase;
      // The loop bends the frequency by pi/T: 0.02 rad after a day.
      const double bent = time * std::numbers::pi / info.loopPeriod + 1e-4;
      ASSERT_NEAR(profile.height[i], 2 * std::cos(phase), 2 * bent) << time;
      ASSERT_NEAR(profile.x[i] - x, -2 * std::sin(phase), 2 * bent) << time;
    }
  }
}

// Closed forms of one trochoid of steepness 1 with a = k A: the mean level lies k A^2/2 below, the variance is
// A^2 (2 - a^2)/4, that of the slopes 1 - sqrt(1 - a^2).
TEST(Trochoids, HaveTheLevelVarianceAndSlopesOfTheTheory) {
  for (const double a : {0.1, 0.4, 0.7}) {
    SeaState sea = still();
    const double wavelength = 60, amplitude = a * wavelength / kTwoPi;
    sea.trochoids = {{amplitude, wavelength, 0, 1, 0}};
    const Profile profile = profileOf(infoOf(sea, 1, 512), 1);
    const double level = meanOver(profile, [&](std::size_t i) { return profile.height[i]; });
    EXPECT_NEAR(level, -0.5 * a * amplitude, 2e-3 * amplitude);
    const double variance = meanOver(profile, [&](std::size_t i) { return std::pow(profile.height[i] - level, 2); });
    EXPECT_NEAR(variance, amplitude * amplitude * (2 - a * a) / 4, 2e-3 * amplitude * amplitude);
    const double slopes = meanOver(profile, [&](std::size_t i) { return profile.slope[i] * profile.slope[i]; });
    EXPECT_NEAR(slopes, 1 - std::sqrt(1 - a * a), 0.01 * slopes) << a;
  }
}

TEST(Trochoids, TheirSteepnessWidensOrNarrowsTheCrests) {
  SeaState sea = still();
  sea.trochoids = {{1, 50, 0, 2.5, 0}};
  const WavesInfo info = infoOf(sea);
  const SeaMoments moments = momentsOf(info);
  EXPECT_NEAR(moments.elevation, 0.5, 1e-6);
  EXPECT_NEAR(moments.horizontal, 0.5 * 2.5 * 2.5, 1e-5);
  sea.choppiness = 0;
  EXPECT_NEAR(momentsOf(infoOf(sea)).horizontal, 0.5 * 2.5 * 2.5, 1e-5) << "choppiness is that of the random waves";
}

TEST(Trochoids, NeverLoop) {
  SeaState sea = still();
  for (int i = 0; i < 12; ++i) {
    sea.trochoids.push_back({0.4, 20.0 + 7 * i, 0.3 * i - 1.5, 100, 0.1 * i});
  }
  const WavesInfo info = infoOf(sea, 2, 256);
  const GridTrochoids grid = trochoidsOnGrid(sea, info.layout, 0);
  double steepest = 0;
  for (const GridTrochoid& placed : grid.waves) {
    steepest += placed.wave.steepness * placed.wave.amplitude * kTwoPi / placed.wave.wavelength;
  }
  EXPECT_NEAR(steepest, 1, 1e-12);
  EXPECT_LT(grid.steepnessScale, 0.1);
  EXPECT_EQ(makeGridSea(sea, info).report.steepnessScale, grid.steepnessScale);
  for (const double warp : {0.0, 0.1}) {
    WavesInfo warped = info;
    warped.warp = warp;
    auto query = *SeaQuery::create(warped);
    for (double time = 0; time < 30; time += 1.3) {
      query.setTime(time);
      for (int i = 0; i < 400; ++i) {
        EXPECT_GE(query.at({1.7 * i, 0.6 * i}).normal.y, 0) << "the surface has folded over";
      }
    }
  }
  sea.trochoids.resize(1);
  sea.trochoids[0].steepness = 1 / (sea.trochoids[0].amplitude * kTwoPi / sea.trochoids[0].wavelength) - 0.1;
  EXPECT_EQ(trochoidsOnGrid(sea, info.layout, 0).steepnessScale, 1);
  // Where the warp makes the wave shorter it must not loop either.
  EXPECT_NEAR(trochoidsOnGrid(sea, info.layout, 0.1).steepnessScale, 1 / 1.46, 0.03);
}

TEST(Trochoids, LieOnTheNearestFreeModes) {
  SeaState sea;
  for (int i = 0; i < 40; ++i) sea.trochoids.push_back({0.1, 2.0 * std::pow(1.1, i), 0.17 * i, 1, 0});
  const WavesInfo info = infoOf(sea, 4);
  const GridTrochoids grid = trochoidsOnGrid(sea, info.layout, 0);
  ASSERT_EQ(grid.waves.size(), 40u);
  for (std::size_t i = 0; i < 40; ++i) {
    const Trochoid &asked = sea.trochoids[i], &got = grid.waves[i].wave;
    const Cascade& cascade = info.layout.cascades[grid.waves[i].cascade];
    const double k = kTwoPi / got.wavelength, wanted = kTwoPi / asked.wavelength;
    EXPECT_GE(k, cascade.kMin);
    EXPECT_LT(k, cascade.kMax);
    const glm::dvec2 off(k * std::cos(got.direction) - wanted * std::cos(asked.direction),
                         k * std::sin(got.direction) - wanted * std::sin(asked.direction));
    // Half a mode each way; at the edge of a ring the nearest may lie across it.
    EXPECT_LE(glm::length(off) * cascade.length / kTwoPi, 1.5) << asked.wavelength;
  }
  sea.trochoids.assign(30, {0.1, 50, 0.2, 1, 0});
  std::set<std::pair<int, int>> modes;
  for (const GridTrochoid& placed : trochoidsOnGrid(sea, info.layout, 0).waves) modes.insert({placed.mx, placed.mz});
  EXPECT_EQ(modes.size(), 30u) << "equal waves stand side by side";
}

TEST(Trochoids, PickedOnesCarryEqualPartsOfTheSpectrum) {
  SeaState sea;
  sea.windSpeed = 12;
  sea.windDirection = 0.9;
  const WavesInfo random = infoOf(sea, 3, 256);
  const double all = momentsOf(random).elevation;
  for (const double roughness : {0.0, 0.3, 1.0}) {
    sea.trochoidPick = {24, roughness, 0.6};
    const WavesInfo info = infoOf(sea, 3, 256);
    EXPECT_NEAR(momentsOf(info).elevation / all, 1, 0.01) << roughness;
    const GridTrochoids grid = trochoidsOnGrid(sea, info.layout, 0);
    if (roughness == 1) {
      EXPECT_TRUE(grid.waves.empty());
      continue;
    }
    ASSERT_EQ(grid.waves.size(), 24u);
    double energy = 0, steepest = 0;
    glm::dvec2 direction(0);
    for (const GridTrochoid& placed : grid.waves) {
      const Trochoid& wave = placed.wave;
      if (roughness == 0) {
        EXPECT_DOUBLE_EQ(wave.amplitude, grid.waves[0].wave.amplitude);
      }
      energy += 0.5 * wave.amplitude * wave.amplitude;
      steepest += wave.steepness * wave.amplitude * kTwoPi / wave.wavelength;
      direction += glm::dvec2(std::cos(wave.direction), std::sin(wave.direction));
    }
    EXPECT_NEAR(energy / all, 0.95 * (1 - roughness), roughness == 0 ? 0.01 : 0.06);
    EXPECT_NEAR(steepest, 0.6, 0.05);
    EXPECT_NEAR(std::atan2(direction.y, direction.x), 0.9, 0.15);
  }
}

TEST(Trochoids, CountInTheSpectrumsIntegrals) {
  SeaState sea = still();
  sea.windDirection = 0.5;
  sea.trochoids = {{1, 40, 0.5, 1, 0}, {0.5, 10, 0.5 + std::numbers::pi / 2, 1, 0}};
  EXPECT_NEAR(significantWaveHeight(sea), 4 * std::sqrt(0.5 + 0.125), 1e-12);
  EXPECT_NEAR(elevationVariance(sea, kTwoPi / 20, 100), 0.125, 1e-12);
  const SlopeVariance slopes = slopeVariance(sea, 0, 100);
  EXPECT_NEAR(slopes.upwind, 0.5 * std::pow(kTwoPi / 40, 2), 1e-12);
  EXPECT_NEAR(slopes.crosswind, 0.125 * std::pow(kTwoPi / 10, 2), 1e-12);
  sea.trochoids.resize(1);
  EXPECT_NEAR(zeroCrossingPeriod(sea), kTwoPi / angularFrequency(kTwoPi / 40, sea.depth), 1e-9);
  sea.trochoids[0].wavelength = 400;
  EXPECT_EQ(longestPeakWavelength(sea), 400);
}

TEST(Trochoids, AreMetWhereTheirCrestsAddUp) {
  SeaState sea = still();
  for (int i = 0; i < 64; ++i) sea.trochoids.push_back({0.5, 40.0 + i, 0.02 * i, 0.1, 0});
  auto query = *SeaQuery::create(infoOf(sea, 2, 256));
  const double crest = query.heightAt({0, 0});
  EXPECT_NEAR(crest, 32, 0.5) << "all phases are 0 at the origin";
  const auto hit = query.intersect({0, 100, 0}, {0, -1, 0}, 200);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->position.y, crest, 1e-6);
}

TEST(Trochoids, WithoutAFreeModeAreRefused) {
  WavesInfo info;
  info.layout.size = 64;
  info.layout.count = 1;
  info.layout.cascades[0] = {100, 0.99 * kTwoPi / 100, 1.01 * kTwoPi / 100};  // four modes, two pairs
  info.sea = still();
  info.sea.trochoids.assign(2, {0.1, 100, 0, 1, 0});
  EXPECT_TRUE(SeaQuery::create(info));
  info.sea.trochoids.resize(3, info.sea.trochoids[0]);
  EXPECT_EQ(SeaQuery::create(info).error().message,
            "SeaState::trochoids[2] finds no free mode in its cascade of this layout: others hold them all");
}

TEST(Trochoids, BadOnesAreNamed) {
  const auto message = [](auto change) {
    SeaState sea;
    sea.trochoids = {{}, {}};
    change(sea);
    return validate(sea).error().message;
  };
  EXPECT_EQ(message([](SeaState& sea) { sea.trochoids[1].amplitude = 0; }),
            "SeaState::trochoids[1]::amplitude is 0, it must lie in 1e-06 … 20 m");
  EXPECT_EQ(message([](SeaState& sea) { sea.trochoids[0].steepness = std::nan(""); }),
            "SeaState::trochoids[0]::steepness is nan, it must lie in 0 … 100");
  EXPECT_EQ(message([](SeaState& sea) { sea.trochoidPick.count = 257; }),
            "TrochoidPick::count is 257, it must lie in 0 … 256");
  EXPECT_EQ(message([](SeaState& sea) { sea.trochoidPick.roughness = 1.5; }),
            "TrochoidPick::roughness is 1.5, it must lie in 0 … 1");
  EXPECT_EQ(message([](SeaState& sea) { sea.trochoids.resize(300); }),
            "SeaState::trochoids has 300 waves, it must have 256 at most");
  WavesInfo info = infoOf(SeaState{}, 1, 64);
  info.sea.trochoids = {{1, 1, 0, 1, 0}};
  EXPECT_NE(SeaQuery::create(info).error().message.find("SeaState::trochoids[0]::wavelength is 1, "),
            std::string::npos);
  auto query = *SeaQuery::create(infoOf(SeaState{}, 1, 64));
  EXPECT_FALSE(query.setSea(info.sea));
}

}  // namespace
