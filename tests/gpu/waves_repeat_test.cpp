/// Whether the sea is seen to repeat: its autocorrelation where it has none of its own.
#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <pelagic/query.hpp>
#include <waves/warp.hpp>

#include "waves_support.hpp"

namespace {

constexpr double kReach = 2000;  ///< Lags looked at [m].

/// The default sea and a light wind's.
std::vector<pelagic::SeaState> twoSeas() {
  std::vector<pelagic::SeaState> seas(2);
  seas[1].windSpeed = 5;
  seas[1].windDirection = 0.7;
  return seas;
}

pelagic::WavesInfo infoOf(const pelagic::SeaState& sea, double warp = pelagic::WavesInfo().warp) {
  pelagic::WavesInfo info;
  info.warp = warp;
  info.sea = sea;
  info.layout = pelagic::waveLayout(sea).value();
  return info;
}

/// Lags of which the patches have images within kReach: multiples of a patch's length, one of each pair.
std::vector<glm::dvec2> imagesOf(double length) {
  std::vector<glm::dvec2> images;
  const int most = static_cast<int>(kReach / length);
  for (int i = 0; i <= most; ++i) {
    for (int j = -most; j <= most; ++j) {
      const glm::dvec2 image = length * glm::dvec2(i, j);
      if ((i > 0 || j > 0) && glm::length(image) <= kReach) images.push_back(image);
    }
  }
  return images;
}

/// Expected autocorrelation at a lag r of the modes of all cascades seen through the warp: the mean over all places p
/// of cos(k (r + w(p + r) - w(p))), in which the phases of the warp's waves are independent.
class Correlation {
 public:
  explicit Correlation(const pelagic::WavesInfo& info)
      : warp_(pelagic::Warp(info.layout, info.warp).relativeTo({0, 0})) {
    const auto size = info.layout.size;
    const double all = pelagic::elevationVariance(info.sea, 0, 1e4);
    for (std::uint32_t c = 0; c < info.layout.count; ++c) {
      const double dk = 2 * std::numbers::pi / info.layout.cascades[c].length;
      const auto modes = pelagic::makeModes(info.sea, info.layout, c, info.loopPeriod);
      for (std::uint32_t i = 0; i < size * size; ++i) {
        if (modes.variance[i] <= 1e-7 * all) continue;
        modes_.push_back(
            {dk * glm::dvec2(pelagic::modeOf(i % size, size), pelagic::modeOf(i / size, size)), modes.variance[i]});
        total_ += modes.variance[i];
      }
    }
    // What is left of a mode where it is shifted by amplitude times the difference of the wave between two places.
    for (std::size_t turn = 0; turn <= kTurns; ++turn) {
      for (std::size_t a = 0; a <= kAmplitudes; ++a) {
        constexpr int kSteps = 128;
        double sum = 0;
        for (int i = 0; i < kSteps; ++i) {
          const double t = (i + 0.5) / kSteps;
          const double apart = 0.5 * static_cast<double>(turn) / kTurns;
          sum += std::cos(static_cast<double>(a) * kStep * (wave(t + apart) - wave(t))) / kSteps;
        }
        left_[turn][a] = sum;
      }
    }
  }
  double at(const glm::dvec2& lag) const {
    double sum = 0;
    std::array<const Row*, 8> rows{};
    std::array<glm::dvec2, 8> shifts{};
    for (std::size_t i = 0; i < 8; ++i) {
      const std::size_t group = i / 4;
      const int lane = static_cast<int>(i % 4);
      const double turns = static_cast<double>(warp_.alongX[group][lane]) * lag.x +
                           static_cast<double>(warp_.alongZ[group][lane]) * lag.y;
      rows[i] = &left_[static_cast<std::size_t>(std::lround(2 * kTurns * std::abs(turns - std::round(turns))))];
      shifts[i] = glm::dvec2(warp_.shiftX[group][lane], warp_.shiftZ[group][lane]);
    }
    for (const Mode& mode : modes_) {
      double term = mode.variance * std::cos(glm::dot(mode.k, lag));
      for (std::size_t i = 0; i < 8; ++i) {
        const double amplitude = std::abs(glm::dot(mode.k, shifts[i]));
        term *= (*rows[i])[std::min(static_cast<std::size_t>(amplitude / kStep + 0.5), kAmplitudes)];
      }
      sum += term;
    }
    return sum / total_;
  }

 private:
  struct Mode {
    glm::dvec2 k;
    double variance;
  };
  static constexpr std::size_t kTurns = 128;
  static constexpr std::size_t kAmplitudes = 2000;
  static constexpr double kStep = 0.01;
  using Row = std::array<double, kAmplitudes + 1>;
  /// As waveWarp() in shader/wave_lookup.glsl.
  static double wave(double turns) {
    const double t = turns - std::round(turns);
    return 8 * t * (1 - 2 * std::abs(t));
  }

  pelagic::shader::WaveWarp warp_;
  std::vector<Mode> modes_;
  double total_ = 0;
  std::vector<Row> left_ = std::vector<Row>(kTurns + 1);
};

TEST(WaveRepeat, NothingIsLeftOfTheWavesAtAnyImageOfAPatch) {
  for (const auto& sea : twoSeas()) {
    const auto info = infoOf(sea);
    const Correlation correlation(info);
    const Correlation unwarped(infoOf(sea, 0));
    EXPECT_NEAR(correlation.at({0, 0}), 1, 1e-9);
    double worst = 0;
    for (const glm::dvec2& image : imagesOf(info.layout.cascades[0].length)) {
      EXPECT_GT(unwarped.at(image), 0.95) << "wind " << sea.windSpeed;
      worst = std::max(worst, std::abs(correlation.at(image)));
    }
    EXPECT_LT(worst, 0.02) << "wind " << sea.windSpeed;
    RecordProperty("worst_" + std::to_string(static_cast<int>(sea.windSpeed)), std::to_string(worst));
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

// 8 km square, of which each lag up to 2 km is seen many times over. The sea is uncorrelated from five of its peak
// waves on; from there to the reach nothing comes back.
TEST(WaveRepeat, NoHeightsOfASquareOfEightKilometresComeBack) {
  for (const auto& sea : twoSeas()) {
    const auto info = infoOf(sea);
    auto query = pelagic::SeaQuery::create(info, 4).value();
    query.setTime(500);
    // Lags of whole samples meet the longest patch's length.
    const double length = info.layout.cascades[0].length;
    const double spacing = length / std::ceil(length / 5);
    const int reach = static_cast<int>(kReach / spacing);
    const int n = 4 * reach;
    std::vector<glm::dvec2> points;
    for (int row = 0; row < n; ++row) {
      for (int column = 0; column < n; ++column) points.push_back(spacing * glm::dvec2(column, row));
    }
    std::vector<double> heights(points.size());
    query.heightsAt(points, heights);
    MeasuredCorrelation measured(heights, n, reach);
    EXPECT_NEAR(measured.at(0, 0), 1, 1e-9);
    double worst = 0;
    for (int row = -reach; row <= reach; ++row) {
      for (int column = 0; column <= reach; ++column) {
        const double lag = spacing * std::hypot(row, column);
        if (lag > kReach || lag < 5 * pelagic::longestPeakWavelength(sea)) continue;
        worst = std::max(worst, std::abs(measured.at(column, row)));
      }
    }
    EXPECT_LT(worst, 0.05) << "wind " << sea.windSpeed;
    RecordProperty("worst_" + std::to_string(static_cast<int>(sea.windSpeed)), std::to_string(worst));
  }
}

}  // namespace
