// Waves that lean forward under the wind.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <pelagic/query.hpp>
#include <pelagic/spectrum.hpp>
#include <random>
#include <waves/lean.hpp>
#include <waves/modes.hpp>
#include <waves/wind_and_swell.hpp>

namespace {

using namespace pelagic;

SeaState seaOf(double wind, double asymmetry) {
  SeaState sea;
  sea.windSpeed = wind;
  sea.windDirection = 0.7;
  sea.spectrum = Spectrum::elfouhaily;
  sea.spreading = Spreading::elfouhaily;
  sea.asymmetry = asymmetry;
  return sea;
}

struct Slopes {
  double deviation = 0;
  double skewness = 0;
};

/// Of the slopes along the wind over points of the world, as a camera counts them.
Slopes slopesOf(SeaState sea) {
  constexpr int kPoints = 20000;
  constexpr double kSide = 20000;  // m
  double square = 0;
  double cube = 0;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-kSide / 2, kSide / 2);
  for (sea.seed = 1; sea.seed <= 4; ++sea.seed) {
    WavesInfo info;
    info.sea = sea;
    info.layout = *waveLayout(sea, 6, 128);
    const SeaQuery query = *SeaQuery::create(info);
    for (int i = 0; i < kPoints; ++i) {
      const glm::dvec3 normal = query.at({place(random), place(random)}).normal;
      const double slope =
          -(normal.x * std::cos(sea.windDirection) + normal.z * std::sin(sea.windDirection)) / normal.y;
      square += slope * slope / (4 * kPoints);
      cube += slope * slope * slope / (4 * kPoints);
    }
  }
  return {std::sqrt(square), cube / (square * std::sqrt(square))};
}

// What was measured is the skewness of all slopes, of which the patches hold most: it goes with the deviation. The mean
// over so many points has a deviation of 0.01, and more in strong winds, where few very steep places count; 0.04 was
// seen.
TEST(Lean, SkewsSlopesAsCoxAndMunkMeasured) {
  for (const double wind : {5.0, 8.0, 11.0, 14.0}) {
    const Slopes slopes = slopesOf(seaOf(wind, 1));
    const double measured = coxMunkSkewness(wind) * slopes.deviation / std::sqrt(coxMunkSlopes(wind).upwind);
    EXPECT_NEAR(slopes.skewness, measured, 0.05 + 0.15 * std::abs(measured)) << wind << " m/s";
    EXPECT_NEAR(slopesOf(seaOf(wind, 0)).skewness, 0, 0.05) << wind << " m/s";
  }
}

TEST(Lean, HasTheSkewnessOfThePaper) {
  EXPECT_NEAR(coxMunkSkewness(10), -0.29, 1e-12);
  EXPECT_EQ(coxMunkSkewness(1), 0);
  EXPECT_NEAR(coxMunkSkewness(14), -0.422, 1e-12);
  EXPECT_EQ(coxMunkSkewness(60), coxMunkSkewness(14));
}

TEST(Lean, GrowsWithTheFactorAndIsNoneWithoutIt) {
  EXPECT_EQ(leanWithWind(seaOf(12, 0)), 0);
  EXPECT_NEAR(leanWithWind(seaOf(12, 2)), 2 * leanWithWind(seaOf(12, 1)), 1e-12);
  EXPECT_GT(leanWithWind(seaOf(12, 1)), 0);
  EXPECT_LT(leanWithWind(seaOf(14, 2)), std::numbers::pi / 2) << "beyond that troughs would be sharp";
}

/// Phase of the displacement behind the linear theory's [rad] of the mode (mx, mz) of a patch.
double leanOf(const CascadeModes& modes, int mx, int mz, std::uint32_t size) {
  const auto index = static_cast<std::size_t>(static_cast<std::uint32_t>(mz) & (size - 1)) * size +
                     (static_cast<std::uint32_t>(mx) & (size - 1));
  const glm::vec2 chop = modes.constants[index].chop;
  return -std::atan2(chop.y, chop.x);
}

TEST(Lean, IsOfTheWindSeaAndWithTheWind) {
  SeaState sea = seaOf(12, 1);
  sea.windDirection = std::atan2(3, 4);
  const double most = leanWithWind(sea);
  WaveLayout layout = *waveLayout(sea, 2, 64);
  const CascadeModes wind = makeModes(sea, layout, 0, 4194304);
  EXPECT_NEAR(leanOf(wind, 12, 9, 64), most, 1e-5);
  EXPECT_NEAR(leanOf(wind, -12, -9, 64), -most, 1e-5) << "waves against the wind lean with it too";
  EXPECT_NEAR(leanOf(wind, -9, 12, 64), 0, 1e-5);
  EXPECT_NEAR(leanOf(wind, 15, 0, 64), most * 0.8, 1e-5) << "the cosine of what is between";
  EXPECT_NEAR(glm::length(wind.constants[9 * 64 + 12].chop), layout.cascades[0].length / (2 * std::numbers::pi * 15),
              1e-5 * layout.cascades[0].length)
      << "the water moves as far";

  // Where the swell has a part of the energy the rest leans.
  sea.swell.push_back({1, 5, sea.windDirection, 20});
  const double dk = 2 * std::numbers::pi / layout.cascades[0].length;
  const CascadeModes both = makeModes(sea, layout, 0, 4194304);
  const WindAndSwell there = waveNumberSpectra(sea, 12 * dk, 9 * dk);
  const WindAndSwell opposite = waveNumberSpectra(sea, -12 * dk, -9 * dk);
  const double ofWind = there.wind + opposite.wind;
  const double share = ofWind / (ofWind + there.swell + opposite.swell);
  EXPECT_GT(share, 0.05);
  EXPECT_LT(share, 0.95);
  EXPECT_NEAR(leanOf(both, 12, 9, 64), most * share, 1e-5);
}

}  // namespace
