#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <pelagic/spectrum.hpp>
#include <waves/unified.hpp>

namespace {

using namespace pelagic;
constexpr double kPi = std::numbers::pi;

/// Trapezium rule over ln x.
double integrateLog(double a, double b, int n, const std::function<double(double)>& f) {
  double sum = 0;
  const double h = std::log(b / a) / n;
  for (int i = 0; i <= n; ++i) {
    const double x = a * std::exp(h * i);
    sum += (i == 0 || i == n ? 0.5 : 1) * x * f(x);
  }
  return sum * h;
}

SeaState unifiedState(double wind, double fetch = 1e7) {
  SeaState sea;
  sea.spectrum = Spectrum::elfouhaily;
  sea.spreading = Spreading::elfouhaily;
  sea.windSpeed = wind;
  sea.fetch = fetch;
  return sea;
}

TEST(Unified, HasThePapersParameters) {
  // Fully developed: Omega_c = 0.84; k_p = k0 Omega_c^2.
  const UnifiedSea developed = unifiedSea(10, 1e9);
  EXPECT_NEAR(developed.inverseAge, 0.84, 1e-6);
  EXPECT_NEAR(developed.peakWaveNumber, 0.0981 * 0.84 * 0.84, 1e-6);
  // 100 km at 10 m/s: X = 0.0981 * 1e5 = 9810; X/X0 = 0.4459; ^0.4 = 0.7239; tanh = 0.6193; ^-0.75 = 1.4324.
  EXPECT_NEAR(unifiedSea(10, 1e5).inverseAge, 0.84 * 1.4324, 1e-4);
  // z0 = 3.7e-5 U^2/g 0.84^0.9 = 3.2238e-4; u* = 0.41 U / ln(10/z0) = 4.1 / 10.3423.
  EXPECT_NEAR(developed.friction, 4.1 / 10.3423, 1e-4);
}

TEST(Unified, HasTheValuesOfAnIndependentEvaluation) {
  // Computed outside of Pelagic from the paper's formulas, 10 m/s, 100 km.
  const UnifiedSea sea = unifiedSea(10, 1e5);
  const double values[][2] = {{0.1, 4.930843e-01}, {1, 5.342696e-03},   {10, 4.171945e-06},
                              {100, 8.470977e-09}, {370, 2.690155e-10}, {1000, 5.325507e-12}};
  for (const auto& [k, s] : values) EXPECT_NEAR(unifiedSpectrum(sea, k) / s, 1, 2e-6) << k;
}

TEST(Unified, CarriesOneVarianceOverFrequenciesAndWaveNumbers) {
  const SeaState sea = unifiedState(8, 2e5);
  const UnifiedSea unified = unifiedSea(8, 2e5);
  const double m0 = integrateLog(1e-3, 1e4, 20000, [&](double k) { return unifiedSpectrum(unified, k); });
  EXPECT_NEAR(elevationVariance(sea, 0, 1e4) / m0, 1, 1e-3);
  EXPECT_NEAR(integrateLog(0.1, 1e4, 20000, [&](double w) { return windSeaSpectrum(sea, w); }) / m0, 1, 1e-3);
  // Psi(k, theta) = S(k) D / k.
  const double k = 2.5;
  double around = 0;
  for (int i = 0; i < 720; ++i) {
    const double theta = 2 * kPi * (i + 0.5) / 720;
    around += waveNumberSpectrum(sea, k * std::cos(theta), k * std::sin(theta)) * k * 2 * kPi / 720;
  }
  EXPECT_NEAR(around / unifiedSpectrum(unified, k), 1, 1e-4);
}

TEST(Unified, HasTheSlopesThatCoxAndMunkMeasured) {
  for (const double wind : {5.0, 7.0, 10.0, 14.0}) {
    const SlopeVariance slopes = slopeVariance(unifiedState(wind), 0, 1e4);
    const SlopeVariance measured = coxMunkSlopes(wind);
    EXPECT_NEAR(slopes.upwind / measured.upwind, 1.1, 0.15) << wind;
    EXPECT_NEAR(slopes.crosswind / measured.crosswind, 1.1, 0.15) << wind;
  }
}

TEST(Unified, SpreadsByItsAsymmetry) {
  const SeaState sea = unifiedState(10);
  const UnifiedSea unified = unifiedSea(10, sea.fetch);
  // D(0) / D(pi/2) = (1 + Delta) / (1 - Delta), the paper's up-wind to cross-wind ratio.
  for (const double k : {0.1, 3.0, 100.0}) {
    const double w = angularFrequency(k, sea.depth);
    const double ratio = windSeaSpreading(sea, w, 0) / windSeaSpreading(sea, w, kPi / 2 - 1e-9);
    const double delta = (ratio - 1) / (ratio + 1);
    EXPECT_NEAR(delta, unifiedAsymmetry(unified, k), 1e-6);
    EXPECT_EQ(windSeaSpreading(sea, w, kPi - 0.3), 0);
    double sum = 0;
    for (int i = 0; i < 2000; ++i) sum += windSeaSpreading(sea, w, 2 * kPi * (i + 0.5) / 2000) * 2 * kPi / 2000;
    EXPECT_NEAR(sum, 1, 1e-4);
  }
  // At the peak c = c_p: tanh(ln(2)/4 + 4 + small).
  EXPECT_NEAR(unifiedAsymmetry(unified, unified.peakWaveNumber), std::tanh(0.25 * std::log(2.0) + 4), 1e-4);
  // The slowest waves feel the wind's friction: tanh(ln(2)/4 + 0.13 u*/0.23 + small).
  EXPECT_NEAR(unifiedAsymmetry(unified, 370), std::tanh(0.17329 + 0.13 * unified.friction / 0.23), 2e-3);
}

SeaState tabled(SpectrumTable table) {
  SeaState sea;
  sea.spectrum = Spectrum::table;
  sea.table = std::move(table);
  return sea;
}

TEST(Table, IsLinearBetweenItsEntriesAndEndsInATail) {
  const SeaState sea = tabled({{0.1, 0.2, 0.4}, {}, {0, 8, 2}});
  ASSERT_TRUE(validate(sea));
  const auto at = [&](double f) { return 2 * kPi * windSeaSpectrum(sea, 2 * kPi * f); };  // [m^2/Hz]
  EXPECT_NEAR(at(0.15), 4, 1e-12);
  EXPECT_NEAR(at(0.2), 8, 1e-12);
  EXPECT_NEAR(at(0.3), 5, 1e-12);
  EXPECT_NEAR(at(0.8), 2 / 32.0, 1e-12);
  EXPECT_EQ(at(0.0999), 0);
  // Triangles of 0.4 and 1.0 m^2, and a tail of S f / 4.
  EXPECT_NEAR(elevationVariance(sea, 0, 1e4), 0.4 + 1.0 + 2 * 0.4 / 4, 1e-3);
  EXPECT_NEAR(significantWaveHeight(sea), 4 * std::sqrt(1.6), 2e-3);
  EXPECT_NEAR(peakPeriod(sea), 5, 1e-12);
}

TEST(Table, ReproducesTheSpectrumItWasSampledFrom) {
  SeaState jonswap;
  jonswap.windSpeed = 12;
  SpectrumTable table;
  for (double f = 0.04; f < 2; f *= 1.01) {
    table.frequency.push_back(f);
    table.density.push_back(2 * kPi * windSeaSpectrum(jonswap, 2 * kPi * f));
  }
  const SeaState sea = tabled(table);
  EXPECT_NEAR(significantWaveHeight(sea) / significantWaveHeight(jonswap), 1, 1e-3);
  EXPECT_NEAR(longestPeakWavelength(sea) / longestPeakWavelength(jonswap), 1, 0.02);
}

TEST(Table, DirectionsAreThoseOfTheWorld) {
  // All energy near 90 degrees (+z), whatever the wind; directions wrap around the turn.
  SpectrumTable table{{0.1, 0.2, 0.3}, {-kPi / 2, 0, kPi / 2, kPi}, {}};
  table.density = {0, 0, 1, 0, 0, 0, 3, 0, 0, 0, 1, 0};
  SeaState sea = tabled(table);
  sea.windDirection = 1.1;
  ASSERT_TRUE(validate(sea));
  // Density falls linearly to 0 at +-90 degrees of its peak: the integral is the peak times pi/2.
  EXPECT_NEAR(2 * kPi * windSeaSpectrum(sea, 2 * kPi * 0.2), 3 * kPi / 2, 1e-12);
  const double k = waveNumberOf(2 * kPi * 0.2, sea.depth);
  const auto toward = [&](double degrees) {
    const double a = degrees * kPi / 180;
    return waveNumberSpectrum(sea, k * std::cos(a), k * std::sin(a));
  };
  EXPECT_GT(toward(90), 0);
  EXPECT_NEAR(toward(45) / toward(90), 0.5, 1e-9);
  EXPECT_NEAR(toward(135) / toward(90), 0.5, 1e-9);
  EXPECT_NEAR(toward(-90) / toward(90), 0, 1e-9);
  // Psi = S(f)/(2 pi) D (dw/dk) / k with S D the table's value.
  EXPECT_NEAR(toward(90), 3 / (2 * kPi) * groupSpeed(k, sea.depth) / k, 1e-9 * toward(90));
}

TEST(Table, TheLayoutHoldsItsLongestTrain) {
  // Swell of 12.5 s, a fifth of the wind sea's density, counts; a bump of a twentieth does not.
  const SeaState sea = tabled({{0.03, 0.04, 0.05, 0.08, 0.1, 0.2, 0.3}, {}, {0, 0.5, 0, 2, 0, 10, 0}});
  EXPECT_NEAR(longestPeakWavelength(sea), 9.81 / (2 * kPi) * 12.5 * 12.5, 0.1);
}

TEST(Table, BadEntriesAreNamed) {
  const SpectrumTable good{{0.1, 0.2}, {}, {1, 0}};
  ASSERT_TRUE(validate(tabled(good)));
  const auto message = [](const SpectrumTable& table) {
    const auto result = validate(tabled(table));
    return result ? std::string() : result.error().message;
  };
  SpectrumTable table = good;
  table.frequency[1] = 0.1;
  EXPECT_EQ(message(table), "SeaState::table.frequency[1] is 0.1, it must exceed the entry before");
  table = good;
  table.frequency[0] = 0;
  EXPECT_EQ(message(table), "SeaState::table.frequency[0] is 0, it must lie in 1e-3 … 50 Hz");
  table = good;
  table.density[0] = std::nan("");
  EXPECT_EQ(message(table), "SeaState::table.density[0] is nan, it must lie in 0 … 1e6");
  table = good;
  table.density = {0, 0};
  EXPECT_EQ(message(table), "SeaState::table.density is 0 everywhere, it must not be");
  table = good;
  table.density = {1, 2, 3};
  EXPECT_EQ(message(table), "SeaState::table.density has 3 entries, it must have 2");
  table = good;
  table.direction = {0, 1};
  EXPECT_EQ(message(table), "SeaState::table.direction has 2 entries, it must have 3 … 720");
  table.direction = {-kPi, 0, kPi};
  table.density.assign(6, 1);
  EXPECT_NE(message(table).find("SeaState::table.direction[2] is 3.14159, it must be less than a turn"),
            std::string::npos);
  EXPECT_EQ(message({}), "SeaState::table.frequency has 0 entries, it must have 2 … 4096");
}

}  // namespace
