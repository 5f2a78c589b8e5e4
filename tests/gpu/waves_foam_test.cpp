#include <numeric>
#include <waves/grid_sea.hpp>

#include "waves_support.hpp"

namespace {

class WaveFoamTest : public support::WavesTest {
 protected:
  std::vector<float> foam(const pelagic::Waves& waves, std::uint32_t cascade, std::uint32_t mip = 0) {
    return common::readFloats(gpu(), waves.maps().foam, mip, cascade);
  }
};

TEST_F(WaveFoamTest, IsTheSameHoweverATimeIsReached) {
  const auto info = support::wavesInfo(64, 2, 15);
  constexpr double kTime = 110.03;
  auto steady = create(info);
  for (double time = 98.0; time < kTime; time += 0.09) record(steady, time);
  record(steady, kTime);
  auto jump = create(info);
  record(jump, kTime);
  auto detour = create(info);
  for (const double time : {5.0, 5.4, 1e6, 111.0, 109.0}) record(detour, time);
  record(detour, kTime);
  for (std::uint32_t mip = 0; mip < steady.maps().foam.mips; ++mip) {
    const auto expected = foam(steady, 0, mip);
    EXPECT_GT(std::accumulate(expected.begin(), expected.end(), 0.0f), 0) << "no foam to compare in mip " << mip;
    EXPECT_EQ(expected, foam(jump, 0, mip)) << "mip " << mip;
    EXPECT_EQ(expected, foam(detour, 0, mip)) << "mip " << mip;
  }
}

TEST_F(WaveFoamTest, FadesOverItsLifetime) {
  const auto info = support::wavesInfo(64, 1, 18);
  auto waves = create(info);
  record(waves, 40);
  const auto before = foam(waves, 0);
  constexpr double kStep = 0.9;
  record(waves, 40 + kStep);
  const auto after = foam(waves, 0);
  double fading = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_GE(after[i], static_cast<double>(before[i]) - (kStep + 0.25) / pelagic::kFoamLifetime - 1e-3);
    if (before[i] > 0.3f && after[i] < before[i]) fading += 1;
  }
  EXPECT_GT(fading, 0);
}

// A crest breaks and runs on; its foam stays with the water, which has come down into the trough behind it.
TEST_F(WaveFoamTest, IsBornOnCrestsAndLeftInTroughs) {
  const auto info = support::wavesInfo(128, 1, 16);
  auto waves = create(info);
  double born = 0, bornHeight = 0, old = 0, oldHeight = 0, oldInTroughs = 0;
  for (int i = 0; i < 8; ++i) {
    record(waves, 400.0 + 61 * i);
    const auto fresh = foam(waves, 0);
    const auto height = read(waves.maps(), 0)[0];
    for (std::size_t texel = 0; texel < fresh.size(); ++texel) {
      if (fresh[texel] > 0.97f) {
        born += 1;
        bornHeight += height[texel];
      } else if (fresh[texel] > 0.2f && fresh[texel] < 0.7f) {
        old += 1;
        oldHeight += height[texel];
        oldInTroughs += height[texel] < 0 ? 1 : 0;
      }
    }
  }
  ASSERT_GT(born, 100);
  ASSERT_GT(old, 100);
  const double deviation = waves.maps().elevationDeviation;
  EXPECT_GT(bornHeight / born, 0.5 * deviation);
  EXPECT_LT(oldHeight / old, 0.25 * deviation);
  EXPECT_GT(oldInTroughs / old, 0.4);
}

TEST_F(WaveFoamTest, CoversWhatTheWindWants) {
  for (const double wind : {4.0, 5.0, 8.0, 12.0, 18.0, 25.0}) {
    const auto info = support::wavesInfo(128, 3, wind);
    auto waves = create(info);
    double covered = 0;
    const int times = wind < 6 ? 14 : 6;  // whitecaps of light winds are rare
    for (int i = 0; i < times; ++i) {
      record(waves, 613.0 * i);
      for (std::uint32_t c = 0; c < info.layout.count; ++c) {
        for (const float value : foam(waves, c)) covered += static_cast<double>(value) / (times * 128 * 128);
      }
    }
    const double wanted = pelagic::whitecapFraction(wind);
    EXPECT_GT(covered, 0.5 * wanted) << wind << " m/s";
    EXPECT_LT(covered, 2.0 * wanted) << wind << " m/s";
  }
}

TEST_F(WaveFoamTest, WhitecapsHaveEdges) {
  const auto info = support::wavesInfo(128, 3, 8);
  auto waves = create(info);
  record(waves, 77);
  double strong = 0, all = 0, clean = 0;
  for (const float value : foam(waves, 0)) {
    all += static_cast<double>(value);
    if (value > 0.25f) strong += static_cast<double>(value);
    if (value == 0) clean += 1;
  }
  EXPECT_GT(strong, 0.5 * all);
  EXPECT_GT(clean, 0.9 * 128 * 128);
}

TEST_F(WaveFoamTest, ShortWavesKeepNone) {
  const auto info = support::wavesInfo(128, 4, 5);
  const std::uint32_t foaming = pelagic::foamCascades(info.layout);
  ASSERT_LT(foaming, 4u);
  auto waves = create(info);
  record(waves, 20);
  for (std::uint32_t c = foaming; c < 4; ++c) {
    for (const std::uint32_t mip : {0u, 3u, 6u}) {
      for (const float value : foam(waves, c, mip)) ASSERT_EQ(value, 0);
    }
  }
}

TEST_F(WaveFoamTest, NoChoppinessNoFoam) {
  auto info = support::wavesInfo(64, 2, 15);
  info.sea.choppiness = 0;
  auto waves = create(info);
  record(waves, 20);
  for (const float value : foam(waves, 0)) ASSERT_EQ(value, 0);
}

}  // namespace
