#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "waves_support.hpp"

namespace {

using support::Fields;

class WaveFieldTest : public support::WavesTest {};

constexpr double kTwoPi = 2 * std::numbers::pi;

/// Sum over the quantised modes of one cascade at (x, z), with phases in extended precision.
glm::dvec3 directSum(const pelagic::CascadeModes& modes, const pelagic::WavesInfo& info, std::uint32_t cascade,
                     const glm::dvec2& point, double time) {
  const auto size = static_cast<int>(info.layout.size);
  const double dk = kTwoPi / info.layout.cascades[cascade].length;
  glm::dvec3 sum(0);  // Dx, h, Dz
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const auto index = static_cast<std::size_t>(row * size + column);
      if (modes.constants[index].cycles == 0) continue;
      const double kx = dk * (column < size / 2 ? column : column - size);
      const double kz = dk * (row < size / 2 ? row : row - size);
      const long double turns = static_cast<long double>(modes.constants[index].cycles) *
                                static_cast<long double>(time) / static_cast<long double>(info.loopPeriod);
      const double wt = kTwoPi * static_cast<double>(turns - std::floor(turns));
      const glm::dvec4 a(modes.amplitude[index]);
      const std::complex<double> h =
          std::complex<double>(a.x, a.y) * std::polar(1.0, -wt) + std::complex<double>(a.z, a.w) * std::polar(1.0, wt);
      const std::complex<double> wave = h * std::polar(1.0, kx * point.x + kz * point.y);
      const glm::dvec2 chop(modes.constants[index].chop);
      const std::complex<double> moved = std::complex<double>(0, 1) * std::complex<double>(chop.x, chop.y) * wave;
      sum += glm::dvec3((kx * moved).real(), wave.real(), (kz * moved).real());
    }
  }
  return sum;
}

TEST_F(WaveFieldTest, AnyTimeIsExact) {
  for (const double loopPeriod : {4194304.0, 37.0}) {
    auto info = support::wavesInfo(64, 2, 12);
    info.loopPeriod = loopPeriod;
    auto waves = create(info);
    std::array<pelagic::CascadeModes, 2> modes;
    for (std::uint32_t c = 0; c < 2; ++c) modes[c] = pelagic::makeModes(info.sea, info.layout, c, loopPeriod);
    for (const double time : {0.0, 3600.0, 86400.0, 30 * 86400.0, -12.25}) {
      record(waves, time);
      double squares = 0;
      constexpr int kPoints = 16;
      for (std::uint32_t c = 0; c < 2; ++c) {
        const auto fields = read(waves.maps(), c);
        const double spacing = info.layout.cascades[c].length / 64;
        for (int p = 0; p < kPoints; ++p) {
          const int column = 5 * p % 64;
          const int row = (29 * p + 7) % 64;
          const auto expected = directSum(modes[c], info, c, spacing * glm::dvec2(column, row), time);
          const auto at = static_cast<std::size_t>(row * 64 + column);
          const glm::dvec3 error = glm::dvec3(fields[1][at], fields[0][at], fields[2][at]) - expected;
          squares += glm::dot(error, error);
        }
      }
      EXPECT_LT(std::sqrt(squares / (2 * kPoints)), 2e-5) << "m RMS, t = " << time << " s, T = " << loopPeriod << " s";
    }
  }
}

/// 25 m/s and swell, Hs about 10 m.
pelagic::WavesInfo storm(std::uint32_t size, std::uint32_t cascades) {
  pelagic::WavesInfo info;
  info.sea.windSpeed = 25;
  info.sea.fetch = 400e3;
  info.sea.swell.push_back({4, 16, 1, 30});
  info.layout = pelagic::waveLayout(info.sea, cascades, size).value();
  info.precision = pelagic::MapPrecision::single;
  return info;
}

TEST_F(WaveFieldTest, AStormIsExactToAMillimetreAfterADayAndAMonth) {
  const auto info = storm(128, 4);
  auto waves = create(info);
  EXPECT_GT(waves.report().gridHeight, 8);
  for (const double time : {86400 + 0.37, 30 * 86400 + 0.37}) {
    record(waves, time);
    double error = 0;  // of the sum over cascades, at most
    for (std::uint32_t c = 0; c < info.layout.count; ++c) {
      const auto fields = read(waves.maps(), c);
      const auto exact = support::referenceFields(info, c, time);
      double squares = 0;  // of the vectors (Dx, h, Dz)
      for (std::size_t f = 0; f < 3; ++f) {
        for (std::size_t i = 0; i < exact[f].size(); ++i) squares += std::pow(fields[f][i] - exact[f][i], 2);
      }
      error += std::sqrt(squares / static_cast<double>(exact[0].size()));
    }
    RecordProperty("rms_after_" + std::to_string(static_cast<int>(time)), std::to_string(error * 1e6) + " um");
    EXPECT_LT(error, 2e-5) << "m RMS, t = " << time << " s";
  }
}

TEST_F(WaveFieldTest, LoopsCloseBitForBit) {
  for (const double loopPeriod : {61.0, 4194304.0}) {
    auto info = storm(64, 2);
    info.loopPeriod = loopPeriod;
    auto waves = create(info);
    for (const double time : {3.0, 86400.25}) {
      record(waves, time);
      const std::array start{read(waves.maps(), 0), read(waves.maps(), 1)};
      record(waves, time + loopPeriod / 3);
      EXPECT_NE(start[0][0], read(waves.maps(), 0)[0]);
      record(waves, time + loopPeriod * 1024);
      for (std::uint32_t c = 0; c < 2; ++c) EXPECT_EQ(start[c], read(waves.maps(), c)) << "T = " << loopPeriod << " s";
    }
  }
}

TEST_F(WaveFieldTest, FoamLoopsToo) {
  auto info = support::wavesInfo(64, 1, 14);
  info.loopPeriod = 10.125;  // no multiple of the quarter second of the foam's clock
  auto waves = create(info);
  record(waves, 3.0625);
  const auto start = common::readFloats(gpu(), waves.maps().foam);
  EXPECT_GT(*std::max_element(start.begin(), start.end()), 0.1f);
  record(waves, 3.0625 + 10.125 * 4);
  EXPECT_EQ(start, common::readFloats(gpu(), waves.maps().foam));
}

TEST_F(WaveFieldTest, VarianceAndSlopesFollowTheSpectrum) {
  auto info = support::wavesInfo(128, 2, 10);
  auto waves = create(info);
  constexpr int kSeas = 12;
  for (std::uint32_t c = 0; c < info.layout.count; ++c) {
    const auto& cascade = info.layout.cascades[c];
    double elevation = 0, slopes = 0, along = 0;
    for (std::uint64_t seed = 1; seed <= kSeas; ++seed) {
      info.sea.seed = seed;
      ASSERT_TRUE(waves.setSea(info.sea));
      record(waves, 977);
      const auto fields = read(waves.maps(), c);
      const auto& sx = fields[3];
      const auto& sz = fields[4];
      elevation += support::varianceOf(fields[0]) / kSeas;
      slopes += (support::varianceOf(sx) + support::varianceOf(sz)) / kSeas;
      for (std::size_t s = 0; s < sx.size(); ++s) {
        const double up = sx[s] * std::cos(info.sea.windDirection) + sz[s] * std::sin(info.sea.windDirection);
        along += up * up / static_cast<double>(kSeas * sx.size());
      }
    }
    const double m0 = pelagic::elevationVariance(info.sea, cascade.kMin, cascade.kMax);
    const auto mss = pelagic::slopeVariance(info.sea, cascade.kMin, cascade.kMax);
    // The m0 of one sea on the longest patch scatters by 8 %, the mean of twelve by less than 3 %.
    EXPECT_NEAR(elevation / m0, 1, 0.07) << "cascade " << c;
    EXPECT_NEAR(slopes / (mss.upwind + mss.crosswind), 1, 0.04) << "cascade " << c;
    EXPECT_NEAR(along / mss.upwind, 1, 0.06) << "cascade " << c;
    // The expected variance of the modes has no scatter; the grid is coarse near the peak only.
    double modes = 0;
    for (const double variance : waves.modeVariance(c)) modes += variance;
    EXPECT_NEAR(modes / m0, 1, 0.03) << "cascade " << c;
  }
}

TEST_F(WaveFieldTest, PatchesHaveNoSeam) {
  const auto info = support::wavesInfo(128, 1);
  auto waves = create(info);
  record(waves, 10);
  const auto fields = read(waves.maps(), 0);
  const double spacing = info.layout.cascades[0].length / 128;
  // The trapezoid rule links neighbours as well across the edge as inside, along columns (x) and rows (z).
  for (const bool alongX : {true, false}) {
    const auto& slope = fields[alongX ? 3 : 4];
    double seam = 0, inside = 0;
    for (std::size_t line = 0; line < 128; ++line) {
      for (std::size_t i = 0; i < 128; ++i) {
        const std::size_t a = alongX ? line * 128 + i : i * 128 + line;
        const std::size_t next = (i + 1) % 128;
        const std::size_t b = alongX ? line * 128 + next : next * 128 + line;
        const double error = fields[0][b] - fields[0][a] - 0.5 * spacing * (slope[a] + slope[b]);
        (next == 0 ? seam : inside) += error * error / (next == 0 ? 128.0 : 127.0 * 128.0);
      }
    }
    EXPECT_LT(std::sqrt(seam), 1.5 * std::sqrt(inside));
    EXPECT_LT(std::sqrt(inside), 0.1 * std::sqrt(support::varianceOf(fields[0])));
  }
}

/// The shift (in samples along x, z) by which `later` is most like `earlier`.
glm::ivec2 bestShift(const std::vector<double>& earlier, const std::vector<double>& later, int size, int range) {
  glm::ivec2 best(0);
  double highest = -1;
  for (int sz = -range; sz <= range; ++sz) {
    for (int sx = -range; sx <= range; ++sx) {
      double sum = 0;
      for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
          const int from = (row - sz + size) % size * size + (column - sx + size) % size;
          sum += later[static_cast<std::size_t>(row * size + column)] * earlier[static_cast<std::size_t>(from)];
        }
      }
      if (sum > highest) {
        highest = sum;
        best = {sx, sz};
      }
    }
  }
  return best;
}

TEST_F(WaveFieldTest, WavesTravelWithTheWind) {
  for (const double direction : {0.0, 0.5 * std::numbers::pi}) {
    auto info = support::wavesInfo(64, 1, 10);
    info.sea.windDirection = direction;
    auto waves = create(info);
    record(waves, 50);
    const auto earlier = read(waves.maps(), 0)[0];
    // A third of a peak wave's length in a third of its period.
    const double peak = pelagic::peakFrequency(info.sea);
    const double length = kTwoPi / pelagic::waveNumberOf(peak, info.sea.depth);
    record(waves, 50 + kTwoPi / peak / 3);
    const auto shift = bestShift(earlier, read(waves.maps(), 0)[0], 64, 6);
    const double expected = length / 3 / (info.layout.cascades[0].length / 64);
    EXPECT_NEAR(shift.x, expected * std::cos(direction), 1.01);
    EXPECT_NEAR(shift.y, expected * std::sin(direction), 1.01);
  }
}

TEST_F(WaveFieldTest, CrestsAreSharpenedByTheDisplacement) {
  const auto info = support::wavesInfo(64, 1, 10);
  auto waves = create(info);
  record(waves, 5);
  const auto fields = read(waves.maps(), 0);
  // Water gathers under crests: the divergence of D is negative where h is high.
  double correlation = 0;
  for (std::size_t i = 0; i < fields[0].size(); ++i) correlation += fields[0][i] * (fields[5][i] + fields[6][i]);
  EXPECT_LT(correlation, 0);
}

}  // namespace
