#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "waves/grid_sea.hpp"
#include "waves/peak.hpp"

namespace {

using namespace pelagic;
constexpr double kTwoPi = 2 * std::numbers::pi;

/// The layout of waveLayout() with every length times `factor`.
WaveLayout scaledLayout(const SeaState& sea, double factor) {
  WaveLayout layout = waveLayout(sea, 3, 128).value();
  for (Cascade& cascade : layout.cascades) {
    cascade.length *= factor;
    cascade.kMin /= factor;
    cascade.kMax /= factor;
  }
  return layout;
}

SeaReport reportOf(const SeaState& sea, double factor = 1) {
  WavesInfo info;
  info.layout = scaledLayout(sea, factor);
  return makeGridSea(sea, info).report;
}

TEST(WeightedPeak, HasItsClosedForm) {
  // Of exp(-b/w^4)/w^5: integral w^(n-20) exp(-4b/w^4) dw = Gamma((19-n)/4) (4b)^((n-19)/4) / 4, so the quotient of
  // n = 1 and n = 0 is (4b)^(1/4) Gamma(4.5)/Gamma(4.75). Calm seas must not underflow.
  SeaState sea;
  sea.spectrum = Spectrum::piersonMoskowitz;
  for (const double wind : {0.3, 10.0, 50.0}) {
    sea.windSpeed = wind;
    const double b = 0.74 * std::pow(9.81 / (1.026 * wind), 4);
    const double exact = std::pow(4 * b, 0.25) * std::tgamma(4.5) / std::tgamma(4.75);
    EXPECT_NEAR(weightedPeakFrequency(sea) / exact, 1, 1e-5) << wind;
  }
}

TEST(WeightedPeak, OfASwellIsThatOfItsShape) {
  // Ochi & Hubble's train, (a r)^4 exp(-a r)/w with r = (wp/w)^4, a = 4.25: with S^4 = w^-68 exp(-4a r), n = 1 over n =
  // 0 is (4a)^(1/4) wp Gamma(66/4)/Gamma(67/4).
  SeaState sea;
  sea.windSpeed = 0.5;
  sea.swell.push_back({2, 12, 0.3, 40});
  const double exact = std::pow(17, 0.25) * kTwoPi / 12 * std::tgamma(16.5) / std::tgamma(16.75);
  EXPECT_NEAR(weightedPeakFrequency(sea) / exact, 1, 1e-5);
}

TEST(ModeEnergies, FindTheFrequencyOfASingleMode) {
  SeaState sea;
  CascadeModes modes;
  modes.variance = {0, 0.5, 0};
  modes.constants.resize(3);
  modes.constants[1].cycles = 190;
  ModeEnergies energies;
  energies.add(modes, 1000);
  const double period = 1000.0 / 190;
  EXPECT_NEAR(energies.weightedPeakFrequency(sea), kTwoPi / period, 1e-12);
  EXPECT_NEAR(gridPeakPeriod(sea, energies) / peakPeriod(sea), weightedPeakFrequency(sea) * period / kTwoPi, 1e-12);
}

TEST(GridPeak, IsTheTargetsInEverySea) {
  std::vector<SeaState> seas;
  for (const double wind : {3.0, 8.0, 14.0, 25.0}) {
    SeaState sea;
    sea.windSpeed = wind;
    sea.windDirection = 0.3 * wind;
    for (const Spectrum spectrum :
         {Spectrum::jonswap, Spectrum::piersonMoskowitz, Spectrum::elfouhaily, Spectrum::phillips}) {
      sea.spectrum = spectrum;
      seas.push_back(sea);
    }
    sea.spectrum = Spectrum::jonswap;
    sea.fetch = 5e3;
    seas.push_back(sea);
    sea.fetch = 1e5;
    sea.swell.push_back({3, 12, 1, 50});  // the larger train up to 14 m/s
    seas.push_back(sea);
    sea.swell[0] = {0.5, 14, 0, 200};
    seas.push_back(sea);
    sea.swell.clear();
    sea.spectrum = Spectrum::tma;
    sea.depth = 10;
    seas.push_back(sea);
  }
  for (const SeaState& sea : seas) {
    const SeaReport report = reportOf(sea);
    EXPECT_DOUBLE_EQ(report.peakPeriod, peakPeriod(sea));
    EXPECT_NEAR(report.gridPeakPeriod / report.peakPeriod, 1, 2e-3)
        << "wind " << sea.windSpeed << " spectrum " << static_cast<int>(sea.spectrum);
  }
}

TEST(GridPeak, DepartsWhenTheLayoutIsTooShort) {
  // Half a peak wavelength fits into the patch: its longest mode has 1/sqrt(2) of the peak's period.
  const SeaState sea;
  EXPECT_NEAR(reportOf(sea, 0.5 / kPatchWavelengths).gridPeakPeriod / peakPeriod(sea), std::sqrt(0.5), 0.01);
  // One and a half: the peak falls between the first modes, and how they lie decides.
  EXPECT_GT(std::abs(reportOf(sea, 1.5 / kPatchWavelengths).gridPeakPeriod / peakPeriod(sea) - 1), 0.02);
}

TEST(GridPeak, IsThatOfTheFrequenciesThatALoopAllows) {
  // One turn a loop of 4 s and the next, 2 s, are the periods about the 5.1 s of the default sea: all peak modes
  // take 4.
  SeaState sea;
  WavesInfo info;
  info.layout = waveLayout(sea, 2, 64).value();
  info.loopPeriod = 4;
  const SeaReport report = makeGridSea(sea, info).report;
  EXPECT_NEAR(report.gridPeakPeriod, 4 * weightedPeakFrequency(sea) / (kTwoPi / peakPeriod(sea)), 0.1);
}

TEST(GridPeak, OfAFlatSeaIsZero) {
  SeaState sea;
  sea.octaveGain.fill(0);
  EXPECT_EQ(reportOf(sea).gridPeakPeriod, 0);
}

}  // namespace
