#include <cmath>
#include <numbers>
#include <pelagic/query.hpp>

#include "waves_support.hpp"

namespace {

class WavesTrochoidTest : public support::WavesTest {};

constexpr std::uint32_t kSize = 128;

/// Sixteen of it fit the patch.
pelagic::WavesInfo oneWave() {
  pelagic::WavesInfo info;
  info.sea.octaveGain.fill(0);
  info.sea.trochoids = {{1.5, 64, 0, 2, 0.3}};
  info.layout = *pelagic::waveLayout(info.sea, 2, kSize, 16 * 64);
  info.precision = pelagic::MapPrecision::single;
  return info;
}

TEST_F(WavesTrochoidTest, StandInTheMaps) {
  const auto info = oneWave();
  auto waves = create(info);
  record(waves, 2.5);
  const pelagic::Trochoid wave = waves.trochoids().at(0);
  EXPECT_NEAR(wave.wavelength, 64, 1e-9);
  const double k = 2 * std::numbers::pi / wave.wavelength;
  const auto maps = read(waves.maps(), 0);
  const double length = info.layout.cascades[0].length;
  for (std::size_t i = 0; i < kSize; ++i) {
    const double x = length * static_cast<double>(i) / kSize;
    const double phase = k * x - pelagic::angularFrequency(k, info.sea.depth) * 2.5 + 0.3;
    EXPECT_NEAR(maps[0][i], 1.5 * std::cos(phase), 1e-4);
    EXPECT_NEAR(maps[1][i], -3.0 * std::sin(phase), 2e-4);
    EXPECT_NEAR(maps[3][i], -1.5 * k * std::sin(phase), 1e-5);
    EXPECT_NEAR(maps[5][i], -3.0 * k * std::cos(phase), 2e-5);
  }
  EXPECT_NEAR(4 * std::sqrt(0.5 * 1.5 * 1.5), waves.report().gridHeight, 1e-4);
}

// A box of n texels weighs a wave of n/m texels by sin(pi m)/(n sin(pi m/n)): from whole to nothing as the wavelength
// falls to the cell's, and the slopes that it takes away are left as variance.
TEST_F(WavesTrochoidTest, FadeByWavelengthOverCellAndLeaveTheirSlopes) {
  const auto info = oneWave();
  auto waves = create(info);
  record(waves, 0);
  const pelagic::Trochoid wave = waves.trochoids().at(0);
  const double k = 2 * std::numbers::pi / wave.wavelength;
  const double slopes = 0.5 * std::pow(k * wave.amplitude, 2);
  const double texel = info.layout.cascades[0].length / kSize;
  // Two texels a wavelength, mip 2, see what their phase lets them see.
  for (const std::uint32_t mip : {0u, 1u, 3u, 4u, 5u}) {
    const double cell = texel * std::exp2(mip);
    const double weight = mip == 0 ? 1 : std::sin(0.5 * k * cell) / (std::exp2(mip) * std::sin(0.5 * k * texel));
    const auto displacement = common::readFloats(gpu(), waves.maps().displacement, mip, 0);
    const auto gradient = common::readFloats(gpu(), waves.maps().gradient, mip, 0);
    const auto moments = common::readFloats(gpu(), waves.maps().moments, mip, 0);
    double height = 0, resolved = 0, left = 0;
    const std::size_t texels = displacement.size() / 4;
    for (std::size_t i = 0; i < texels; ++i) {
      height += std::pow(static_cast<double>(displacement[4 * i + 1]), 2) / static_cast<double>(texels);
      resolved += std::pow(static_cast<double>(gradient[4 * i]), 2) / static_cast<double>(texels);
      left += static_cast<double>(moments[4 * i]) / static_cast<double>(texels);
    }
    EXPECT_NEAR(height, 0.5 * std::pow(wave.amplitude * weight, 2), 1e-4) << mip;
    EXPECT_NEAR(resolved, slopes * weight * weight, 1e-3 * slopes) << mip;
    EXPECT_NEAR(resolved + left, slopes, 1e-3 * slopes) << mip;
  }
}

TEST_F(WavesTrochoidTest, AreInTheQueriesToo) {
  auto info = support::wavesInfo(64, 2, 9);
  info.precision = pelagic::MapPrecision::single;
  info.warp = 0;
  info.sea.trochoids = {{0.8, 60, 1, 1, 0}, {0.3, 25, -0.5, 3, 1}};
  auto waves = create(info);
  record(waves, 5);
  auto query = *pelagic::SeaQuery::create(info);
  query.setTime(5);
  const auto long_ = read(waves.maps(), 0), short_ = read(waves.maps(), 1);
  const glm::dvec2 displaced(long_[1][0] + short_[1][0], long_[2][0] + short_[2][0]);
  EXPECT_NEAR(query.heightAt(displaced), long_[0][0] + short_[0][0], 1e-4 * waves.report().gridHeight);
}

}  // namespace
