/// How the sum of the cascades repeats: its autocorrelation where the sea itself has none.
#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include "waves_support.hpp"

namespace {

constexpr double kReach = 2000;  ///< Lags looked at [m].

/// A periodic field on a square lattice, linear between its samples; row = z.
struct Periodic {
  std::vector<double> values;
  std::int64_t size = 0;
  double length = 0;  ///< [m]

  double at(const glm::dvec2& p) const {
    const glm::dvec2 scaled = p * (static_cast<double>(size) / length);
    const glm::dvec2 base = glm::floor(scaled);
    const glm::dvec2 f = scaled - base;
    const auto texel = [&](std::int64_t x, std::int64_t z) {
      return values[static_cast<std::size_t>((z % size + size) % size * size + (x % size + size) % size)];
    };
    const auto x = static_cast<std::int64_t>(base.x);
    const auto z = static_cast<std::int64_t>(base.y);
    return std::lerp(std::lerp(texel(x, z), texel(x + 1, z), f.x), std::lerp(texel(x, z + 1), texel(x + 1, z + 1), f.x),
                     f.y);
  }
};

/// Sum over modes of variance cos(k r) at all lags r of a patch [m^2], four lags per sample.
Periodic correlationOf(const std::vector<double>& variance, std::uint32_t modes, double length) {
  const std::uint32_t size = 4 * modes;
  std::vector<std::complex<double>> field(static_cast<std::size_t>(size) * size);
  for (std::uint32_t row = 0; row < modes; ++row) {
    for (std::uint32_t column = 0; column < modes; ++column) {
      const auto wrap = [&](std::uint32_t i) { return i < modes / 2 ? i : size - modes + i; };
      field[static_cast<std::size_t>(wrap(row)) * size + wrap(column)] = variance[row * modes + column];
    }
  }
  auto* data = reinterpret_cast<fftw_complex*>(field.data());
  const int side = static_cast<int>(size);
  fftw_plan plan = fftw_plan_dft_2d(side, side, data, data, FFTW_BACKWARD, FFTW_ESTIMATE);
  fftw_execute(plan);
  fftw_destroy_plan(plan);
  Periodic result{{}, size, length};
  result.values.reserve(field.size());
  for (const auto& value : field) result.values.push_back(value.real());
  return result;
}

/// Expected autocorrelation [1] of the sum of a layout's cascades, by lag.
class Correlation {
 public:
  explicit Correlation(const pelagic::WavesInfo& info) {
    for (std::uint32_t c = 0; c < info.layout.count; ++c) {
      const auto modes = pelagic::makeModes(info.sea, info.layout, c, info.loopPeriod);
      cascades_.push_back(correlationOf(modes.variance, info.layout.size, info.layout.cascades[c].length));
      total_ += cascades_.back().at({0, 0});
    }
  }
  double at(const glm::dvec2& lag) const {
    double sum = 0;
    for (const Periodic& cascade : cascades_) sum += cascade.at(lag);
    return sum / total_;
  }
  /// The part of the variance that a cascade holds [1].
  double share(std::uint32_t cascade) const { return cascades_[cascade].at({0, 0}) / total_; }

 private:
  std::vector<Periodic> cascades_;
  double total_ = 0;
};

/// The default sea, a light wind's, and a sea with swell.
std::vector<pelagic::SeaState> threeSeas() {
  std::vector<pelagic::SeaState> seas(3);
  seas[1].windSpeed = 5;
  seas[1].windDirection = 0.7;
  seas[2].windSpeed = 14;
  seas[2].swell.push_back({1.5, 12, 0.7, 40});
  return seas;
}

pelagic::WavesInfo infoOf(const pelagic::SeaState& sea, double scale = 1) {
  pelagic::WavesInfo info;
  info.sea = sea;
  info.layout = pelagic::waveLayout(sea).value();
  info.precision = pelagic::MapPrecision::single;
  for (pelagic::Cascade& cascade : info.layout.cascades) {
    cascade.length *= scale;
    cascade.kMin /= scale;
    cascade.kMax /= scale;
  }
  return info;
}

/// Lags from which on a wind sea of one direction is uncorrelated, below 0.03, in peak wavelengths of its longest
/// train.
constexpr double kOwn = 3;

/// The largest correlation at lags that are longer than kOwn peak waves and the shortest patch, every 4 m and at the
/// patches' own lengths, within kReach. `insidePatch`: not at those that are as close to an image of lag 0.
double worst(const pelagic::WavesInfo& info, const Correlation& correlation, bool insidePatch) {
  const auto& cascades = info.layout.cascades;
  const double own = kOwn * pelagic::longestPeakWavelength(info.sea);
  const double least = std::max(own, cascades[info.layout.count - 1].length);
  double largest = 0;
  const auto look = [&](const glm::dvec2& lag) {
    const double distance = glm::length(lag);
    if (distance < least || distance > kReach) return;
    if (insidePatch && glm::length(lag - glm::round(lag / cascades[0].length) * cascades[0].length) < own) return;
    largest = std::max(largest, std::abs(correlation.at(lag)));
  };
  for (double x = 0; x <= kReach; x += 4) {
    for (double z = -kReach; z <= kReach; z += 4) look({x, z});
  }
  for (std::uint32_t c = 0; c < info.layout.count; ++c) {
    for (int i = -6; i <= 6; ++i) {
      for (int j = 0; j <= 6; ++j) look(glm::dvec2(i, j) * cascades[c].length);
    }
  }
  return largest;
}

class WaveRepeatTest : public support::WavesTest {};

TEST(WaveRepeat, NothingRepeatsInsideTheLongestPatch) {
  for (const auto& sea : threeSeas()) {
    const auto info = infoOf(sea);
    EXPECT_LT(worst(info, Correlation(info), true), 0.05) << "wind " << sea.windSpeed;
  }
}

TEST(WaveRepeat, ACascadesShareOfTheVarianceReturnsAtItsLength) {
  // So the sum is seen to repeat at the longest patch, which holds nearly all of it. A longest patch beyond the reach
  // leaves the share of the second, which then holds more.
  for (const double scale : {1.0, 7.0}) {
    const auto info = infoOf(threeSeas()[0], scale);
    const Correlation correlation(info);
    std::uint32_t longest = 0;
    while (info.layout.cascades[longest].length > kReach) ++longest;
    EXPECT_EQ(longest, scale == 1 ? 0u : 1u);
    const double share = correlation.share(longest);
    EXPECT_GT(share, scale == 1 ? 0.98 : 0.15);
    EXPECT_NEAR(worst(info, correlation, false), share, 0.02) << "scale " << scale;
  }
}

/// Autocorrelation of a square of n x n samples at lags of whole samples, every lag over the pairs that there are.
class MeasuredCorrelation {
 public:
  MeasuredCorrelation(const std::vector<double>& heights, int n, int reach) : n_(n), padded_(n + reach) {
    const int half = padded_ / 2 + 1;
    values_.assign(static_cast<std::size_t>(padded_) * static_cast<std::size_t>(2 * half), 0.0);
    const double mean = support::meanOf(heights);
    variance_ = support::varianceOf(heights);
    for (int row = 0; row < n; ++row) {
      for (int column = 0; column < n; ++column) value(row, column) = heights[index(row, column, n)] - mean;
    }
    auto* spectrum = reinterpret_cast<fftw_complex*>(values_.data());
    fftw_plan forward = fftw_plan_dft_r2c_2d(padded_, padded_, values_.data(), spectrum, FFTW_ESTIMATE);
    fftw_plan backward = fftw_plan_dft_c2r_2d(padded_, padded_, spectrum, values_.data(), FFTW_ESTIMATE);
    fftw_execute(forward);
    auto* complex = reinterpret_cast<std::complex<double>*>(values_.data());
    for (std::size_t i = 0; i < values_.size() / 2; ++i) complex[i] = std::norm(complex[i]);
    fftw_execute(backward);
    fftw_destroy_plan(forward);
    fftw_destroy_plan(backward);
  }
  double at(int dx, int dz) {
    const double pairs = static_cast<double>(n_ - std::abs(dx)) * (n_ - std::abs(dz));
    const double sum = value((dz + padded_) % padded_, (dx + padded_) % padded_);
    return sum / (pairs * variance_ * padded_ * padded_);
  }

 private:
  static std::size_t index(int row, int column, int width) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
  double& value(int row, int column) { return values_[index(row, column, 2 * (padded_ / 2 + 1))]; }
  int n_;
  int padded_;
  double variance_ = 0;
  std::vector<double> values_;
};

TEST_F(WaveRepeatTest, RenderedHeightsRepeatAsTheirModesSay) {
  std::optional<pelagic::Waves> waves;
  for (const auto& sea : threeSeas()) {
    const auto info = infoOf(sea);
    waves = create(info);
    record(*waves, 500);
    std::vector<Periodic> maps;
    for (std::uint32_t c = 0; c < info.layout.count; ++c) {
      maps.push_back({read(waves->maps(), c)[0], info.layout.size, info.layout.cascades[c].length});
    }
    // Lags of whole samples meet the longest patch's length.
    const double length = info.layout.cascades[0].length;
    const int perPatch = static_cast<int>(std::ceil(length / 4));
    const double spacing = length / perPatch;
    const int reach = static_cast<int>(kReach / spacing);
    const int n = 2 * reach;
    std::vector<double> heights;
    for (int row = 0; row < n; ++row) {
      for (int column = 0; column < n; ++column) {
        double sum = 0;
        for (const Periodic& map : maps) sum += map.at(spacing * glm::dvec2(column, row));
        heights.push_back(sum);
      }
    }
    MeasuredCorrelation measured(heights, n, reach);
    const Correlation expected(info);
    EXPECT_NEAR(measured.at(0, 0), 1, 1e-9);
    for (const auto& [i, j] : {std::pair{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {2, 1}}) {
      if (length * std::hypot(i, j) > kReach) continue;
      const double exact = expected.at(length * glm::dvec2(i, j));
      EXPECT_NEAR(measured.at(i * perPatch, j * perPatch), exact, 0.05) << "patch " << i << ", " << j;
      RecordProperty("repeats_" + std::to_string(i) + "_" + std::to_string(j), std::to_string(exact));
    }
    // Half-way between, nothing but the scatter of one patch of 64 peak waves.
    EXPECT_LT(std::abs(measured.at(perPatch / 2, perPatch / 2)), 0.3);
  }
}

}  // namespace
