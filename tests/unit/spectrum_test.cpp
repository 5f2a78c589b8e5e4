#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <pelagic/spectrum.hpp>

#include "waves/spreading.hpp"

namespace {

using namespace pelagic;
constexpr double kPi = std::numbers::pi;

/// Simpson's rule.
double integrate(double a, double b, int n, const std::function<double(double)>& f) {
  double sum = f(a) + f(b);
  const double h = (b - a) / n;
  for (int i = 1; i < n; ++i) sum += (i % 2 ? 4 : 2) * f(a + h * i);
  return sum * h / 3;
}

double varianceOf(const std::function<double(double)>& spectrum) {
  return integrate(std::log(1e-2), std::log(1e3), 20000, [&](double x) { return std::exp(x) * spectrum(std::exp(x)); });
}

TEST(Dispersion, HasItsLimits) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(angularFrequency(0.1, infinity), std::sqrt(9.81 * 0.1), 1e-6);
  EXPECT_NEAR(angularFrequency(1e-4, 10), 1e-4 * std::sqrt(9.81 * 10), 1e-9);  // shallow: c = sqrt(g h)
  // The slowest wave: 0.23 m/s at 364 rad/m.
  const auto speed = [&](double k) { return angularFrequency(k, infinity) / k; };
  EXPECT_NEAR(speed(364), 0.232, 0.001);
  EXPECT_LT(speed(364), speed(330));
  EXPECT_LT(speed(364), speed(400));
}

TEST(Dispersion, GroupSpeedIsTheDerivative) {
  for (const double depth : {2.0, 30.0, std::numeric_limits<double>::infinity()}) {
    for (const double k : {0.01, 0.3, 5.0, 200.0}) {
      const double d = 1e-5 * k;
      const double slope = (angularFrequency(k + d, depth) - angularFrequency(k - d, depth)) / (2 * d);
      EXPECT_NEAR(groupSpeed(k, depth), slope, 1e-6 * slope) << "k " << k << " depth " << depth;
      EXPECT_NEAR(waveNumberOf(angularFrequency(k, depth), depth), k, 1e-12 * k);
    }
  }
}

TEST(Spectra, PiersonMoskowitzHasItsClosedForm) {
  SeaState sea;
  sea.spectrum = Spectrum::piersonMoskowitz;
  for (const double wind : {5.0, 10.0, 20.0}) {
    sea.windSpeed = wind;
    const double w0 = 9.81 / (1.026 * wind);
    const double m0 = 8.1e-3 * 9.81 * 9.81 / (4 * 0.74 * std::pow(w0, 4));
    EXPECT_NEAR(varianceOf([&](double w) { return windSeaSpectrum(sea, w); }), m0, 2e-5 * m0);
    EXPECT_NEAR(significantWaveHeight(sea), 4 * std::sqrt(m0), 2e-3 * std::sqrt(m0));
  }
}

TEST(Spectra, JonswapMeetsPiersonMoskowitzWhenFullyDeveloped) {
  SeaState young;
  young.windSpeed = 10;
  young.fetch = 1e7;
  SeaState developed = young;
  developed.spectrum = Spectrum::piersonMoskowitz;
  EXPECT_NEAR(elevationVariance(young, 0, 1e4) / elevationVariance(developed, 0, 1e4), 1, 0.02);
  // gamma = 3.3 holds 1.524 times the variance alpha g^2 / (5 wp^4) of gamma = 1 (DNV-RP-C205 3.5.5.5: Hs follows from
  // the normalising factor 1 - 0.287 ln gamma = 0.657).
  young.fetch = 50e3;
  const double alpha = 0.076 * std::pow(100 / (50e3 * 9.81), 0.22);
  const double peak = 22 * std::cbrt(9.81 * 9.81 / (10 * 50e3));
  const double unpeaked = alpha * 9.81 * 9.81 / (5 * std::pow(peak, 4));
  EXPECT_NEAR(elevationVariance(young, 0, 1e4) * 0.657 / unpeaked, 1, 0.01);
}

TEST(Spectra, JonswapPeaksWithItsOvershoot) {
  SeaState sea;
  sea.fetch = 50e3;
  const double peak = peakFrequency(sea);
  EXPECT_NEAR(peak, 22 * std::cbrt(9.81 * 9.81 / (8 * 50e3)), 1e-12);
  const double alpha = 0.076 * std::pow(64 / (50e3 * 9.81), 0.22);
  const double base = alpha * 9.81 * 9.81 * std::pow(peak, -5) * std::exp(-1.25);
  EXPECT_NEAR(windSeaSpectrum(sea, peak), 3.3 * base, 1e-9);
  EXPECT_GT(windSeaSpectrum(sea, peak), windSeaSpectrum(sea, 1.02 * peak));
  EXPECT_GT(windSeaSpectrum(sea, peak), windSeaSpectrum(sea, 0.98 * peak));
}

TEST(Spectra, JonswapIsNarrowerBelowItsPeak) {
  // One sigma from the peak, 0.07 below and 0.09 above it, gamma's exponent is exp(-1/2) (Hasselmann et al. 1973).
  SeaState sea;
  sea.fetch = 50e3;
  const double peak = peakFrequency(sea);
  const double alpha = 0.076 * std::pow(64 / (50e3 * 9.81), 0.22);
  for (const double x : {0.93, 1.09}) {
    const double base = alpha * 9.81 * 9.81 * std::pow(x * peak, -5) * std::exp(-1.25 * std::pow(x, -4));
    EXPECT_NEAR(windSeaSpectrum(sea, x * peak) / base, std::pow(3.3, std::exp(-0.5)), 1e-9) << x;
  }
}

TEST(Spectra, PeakWhereTheirPeakFrequencySays) {
  SeaState sea;
  for (const Spectrum kind : {Spectrum::phillips, Spectrum::piersonMoskowitz, Spectrum::jonswap}) {
    sea.spectrum = kind;
    const double peak = peakFrequency(sea);
    for (const double x : {0.98, 1.02}) {
      EXPECT_GT(windSeaSpectrum(sea, peak), windSeaSpectrum(sea, x * peak)) << static_cast<int>(kind) << " at " << x;
    }
  }
}

TEST(Spectra, PhillipsHasTheVarianceOfTheDevelopedSea) {
  SeaState phillips;
  phillips.spectrum = Spectrum::phillips;
  SeaState developed;
  developed.spectrum = Spectrum::piersonMoskowitz;
  EXPECT_NEAR(elevationVariance(phillips, 0, 1e4) / elevationVariance(developed, 0, 1e4), 1, 1e-3);
  // Psi(k) goes as exp(-1/(kL)^2)/k^4 in deep water where capillarity does not count.
  phillips.spreading = Spreading::cos2;
  const double length = 64 / 9.81;
  const auto shape = [&](double k) { return std::exp(-1 / (k * length * k * length)) / std::pow(k, 4); };
  EXPECT_NEAR(waveNumberSpectrum(phillips, 0.4, 0) / waveNumberSpectrum(phillips, 0.1, 0), shape(0.4) / shape(0.1),
              1e-4 * shape(0.4) / shape(0.1));
}

TEST(Spectra, TmaIsJonswapTimesKitaigorodskii) {
  SeaState sea;
  sea.depth = 6;
  const double w = 1.2;
  const double kh = waveNumberOf(w, 6) * 6;
  const double deep = windSeaSpectrum(sea, w);
  sea.spectrum = Spectrum::tma;
  EXPECT_NEAR(windSeaSpectrum(sea, w) / deep, std::pow(std::tanh(kh), 2) / (1 + 2 * kh / std::sinh(2 * kh)), 1e-9);
  sea.depth = std::numeric_limits<double>::infinity();
  EXPECT_DOUBLE_EQ(windSeaSpectrum(sea, w), deep);
}

TEST(Spectra, ZeroCrossingPeriodHasItsClosedForm) {
  // Of Pierson & Moskowitz's exp(-b/w^4)/w^5: m0 = C/(4b), m2 = C sqrt(pi/b)/4, so Tz = 2 pi / (pi b)^(1/4).
  SeaState sea;
  sea.spectrum = Spectrum::piersonMoskowitz;
  sea.windSpeed = 14;
  const double b = 0.74 * std::pow(9.81 / (1.026 * 14), 4);
  EXPECT_NEAR(zeroCrossingPeriod(sea), 2 * kPi / std::pow(kPi * b, 0.25), 0.01);
}

TEST(Spectra, OctaveGainScalesAmplitudes) {
  SeaState plain;
  plain.swell.push_back({1, 24, 0, 20});  // 900 m
  SeaState sea = plain;
  sea.octaveGain[5] = 3;  // 16 m
  const auto ratio = [&](double wavelength) {
    const double k = 2 * kPi / wavelength;
    return std::sqrt(waveNumberSpectrum(sea, k, 0) / waveNumberSpectrum(plain, k, 0));
  };
  EXPECT_NEAR(ratio(16), 3, 1e-9);
  EXPECT_NEAR(ratio(16 * std::sqrt(2)), 2, 1e-9);  // half an octave away
  EXPECT_NEAR(ratio(8), 1, 1e-9);
  EXPECT_NEAR(ratio(33), 1, 1e-9);
  sea.octaveGain.fill(2);
  EXPECT_NEAR(ratio(900), 2, 1e-9);  // beyond the ends, too
  EXPECT_NEAR(ratio(0.01), 2, 1e-9);
  EXPECT_NEAR(significantWaveHeight(sea) / significantWaveHeight(plain), 2, 1e-9);
  const SlopeVariance with = slopeVariance(sea, 0, 50);
  const SlopeVariance without = slopeVariance(plain, 0, 50);
  EXPECT_NEAR(with.upwind / without.upwind, 4, 1e-9);
  EXPECT_NEAR(with.crosswind / without.crosswind, 4, 1e-9);
  EXPECT_NEAR(frequencySpectrum(sea, 1) / frequencySpectrum(plain, 1), 4, 1e-9);
}

TEST(Spectra, SwellHasItsHeightAndPeriod) {
  const Swell swell{2.5, 12, 0.3, 40};
  EXPECT_NEAR(varianceOf([&](double w) { return swellSpectrum(swell, w); }), 2.5 * 2.5 / 16, 1e-6);
  const double peak = 2 * kPi / 12;
  EXPECT_GT(swellSpectrum(swell, peak), swellSpectrum(swell, 1.01 * peak));
  EXPECT_GT(swellSpectrum(swell, peak), swellSpectrum(swell, 0.99 * peak));
}

TEST(Spreadings, IntegrateToOneAtEveryFrequency) {
  SeaState sea;
  for (const Spreading kind :
       {Spreading::cos2, Spreading::mitsuyasu, Spreading::hasselmann, Spreading::donelanBanner}) {
    sea.spreading = kind;
    for (const double relative : {0.3, 0.94, 1.0, 1.3, 2.0, 10.0, 100.0}) {
      const double w = relative * peakFrequency(sea);
      const double whole = integrate(-kPi, kPi, 20000, [&](double theta) { return windSeaSpreading(sea, w, theta); });
      // Where s is near 0 the quadrature itself errs by 1e-5 at the kink at 180 degrees.
      EXPECT_NEAR(whole, 1, 3e-5) << static_cast<int>(kind) << " at " << relative << " peak frequencies";
      EXPECT_GE(windSeaSpreading(sea, w, 0.2), windSeaSpreading(sea, w, 1.2));
      EXPECT_NEAR(windSeaSpreading(sea, w, 0.5), windSeaSpreading(sea, w, 0.5 - 2 * kPi), 1e-12);
    }
  }
}

TEST(Spreadings, SwellSharpeningAddsToTheExponentAndKeepsTheIntegral) {
  SeaState broad;
  for (const Spreading kind : {Spreading::cos2, Spreading::mitsuyasu, Spreading::hasselmann, Spreading::donelanBanner,
                               Spreading::elfouhaily}) {
    broad.spreading = kind;
    for (const double xi : {0.3, 1.0}) {
      SeaState sharp = broad;
      sharp.swellSharpening = xi;
      for (const double relative : {0.5, 1.0, 3.0}) {
        const double w = relative * peakFrequency(broad);
        const double exponent = 16 * std::tanh(1 / relative) * xi * xi;  // w_p over w, not w over w_p
        const auto ratio = [&](double theta) {
          return windSeaSpreading(sharp, w, theta) / windSeaSpreading(broad, w, theta);
        };
        EXPECT_NEAR(ratio(1) / ratio(0), std::pow(std::cos(0.5), 2 * exponent), 1e-9) << static_cast<int>(kind);
        const double whole =
            integrate(-kPi, kPi, 20000, [&](double theta) { return windSeaSpreading(sharp, w, theta); });
        EXPECT_NEAR(whole, 1, 3e-5) << static_cast<int>(kind) << " at " << relative << " peak frequencies";
      }
    }
  }
}

TEST(Spreadings, CosinePowerHasTheGammaNorm) {
  for (const double s : {0.0, 0.03, 0.5, 1.0, 7.3, 8.0, 60.0, 200.0}) {
    const double norm = std::exp(std::lgamma(s + 1) - std::lgamma(s + 0.5)) / (2 * std::sqrt(kPi));
    EXPECT_NEAR(cosinePower(s, 0) / norm, 1, 1e-9) << "s " << s;
    EXPECT_NEAR(cosinePower(s, 1.1) / norm, std::pow(std::cos(0.55), 2 * s), 1e-9) << "s " << s;
  }
}

TEST(Spreadings, HasselmannHasItsExponents) {
  SeaState sea;
  sea.spreading = Spreading::hasselmann;
  const double peak = peakFrequency(sea);
  // cos^2s(theta/2): D(theta)/D(0) gives s.
  const auto exponent = [&](double relative) {
    const double ratio = windSeaSpreading(sea, relative * peak, 1.0) / windSeaSpreading(sea, relative * peak, 0);
    return std::log(ratio) / (2 * std::log(std::cos(0.5)));
  };
  EXPECT_NEAR(exponent(0.8), 6.97 * std::pow(0.8, 4.06), 1e-9);
  const double age = 8 * peak / 9.81;
  EXPECT_NEAR(exponent(2), 9.77 * std::pow(2, -2.33 - 1.45 * (age - 1.17)), 1e-9);
}

TEST(Spreadings, MitsuyasuHasItsExponents) {
  // Mitsuyasu et al. (1975): s = 11.5 (U/c_p)^-2.5 at the peak, times (f/f_p)^5 below it and (f/f_p)^-2.5 above.
  SeaState sea;
  sea.spreading = Spreading::mitsuyasu;
  const double peak = peakFrequency(sea);
  const double largest = 11.5 * std::pow(8 * peak / 9.81, -2.5);
  const double values[][2] = {{0.8, 0.32768}, {1, 1}, {4, 1.0 / 32}};
  for (const auto& [relative, share] : values) {
    const double ratio = windSeaSpreading(sea, relative * peak, 1.0) / windSeaSpreading(sea, relative * peak, 0);
    EXPECT_NEAR(std::log(ratio) / (2 * std::log(std::cos(0.5))), largest * share, 1e-9) << relative;
  }
}

TEST(Spreadings, DonelanAndBannerHaveTheirCoefficients) {
  // beta of sech^2(beta theta): Donelan et al. (1985) up to 1.6 f_p, beyond it Banner (1990), log10 beta =
  // -0.4 + 0.8393 exp(-0.567 ln (f/f_p)^2).
  SeaState sea;
  sea.spreading = Spreading::donelanBanner;
  const double values[][2] = {{0.7, 2.61 * std::pow(0.7, 1.3)},
                              {1.2, 2.28 / std::pow(1.2, 1.3)},
                              {3, std::pow(10, -0.4 + 0.8393 * std::pow(3, -1.134))}};
  for (const auto& [relative, beta] : values) {
    const double w = relative * peakFrequency(sea);
    const double ratio = windSeaSpreading(sea, w, 0.4) / windSeaSpreading(sea, w, 0);
    EXPECT_NEAR(std::acosh(1 / std::sqrt(ratio)) / 0.4, beta, 1e-9) << relative;
  }
}

TEST(WaveNumberSpectrum, IsSTimesDTimesGroupSpeedOverWaveNumber) {
  SeaState sea;
  sea.windDirection = 0.4;
  sea.depth = 20;
  const Swell swell{1.5, 9, 2.0, 30};
  sea.swell.push_back(swell);
  for (const double k : {0.05, 0.3, 2.0}) {
    for (const double theta : {0.1, 0.9, 1.8, -2.5}) {
      const double w = angularFrequency(k, 20);
      const double norm = std::exp(std::lgamma(31) - std::lgamma(30.5)) / (2 * std::sqrt(kPi));
      const double expected = windSeaSpectrum(sea, w) * windSeaSpreading(sea, w, theta - 0.4) +
                              swellSpectrum(swell, w) * norm * std::pow(std::cos((theta - 2) / 2), 60);
      const double psi = waveNumberSpectrum(sea, k * std::cos(theta), k * std::sin(theta));
      EXPECT_NEAR(psi / (expected * groupSpeed(k, 20) / k), 1, 1e-9) << k << " toward " << theta;
    }
  }
}

TEST(WaveNumberSpectrum, HoldsTheVarianceAndSlopesOfTheFrequencySpectrum) {
  SeaState sea;
  sea.windDirection = 0.7;
  sea.depth = 20;
  sea.swell.push_back({1.5, 9, 2.0, 30});
  const double kMax = 20;
  double m0 = 0, along = 0, across = 0;
  constexpr int kAngles = 96;  // exact: the narrowest train is a sum of 30 harmonics
  for (int i = 0; i < kAngles; ++i) {
    const double theta = 2 * kPi * i / kAngles;
    m0 += integrate(std::log(1e-3), std::log(kMax), 2000, [&](double x) {
      const double k = std::exp(x);
      return k * k * waveNumberSpectrum(sea, k * std::cos(theta), k * std::sin(theta));
    });
    const double slopes = integrate(std::log(1e-3), std::log(kMax), 2000, [&](double x) {
      const double k = std::exp(x);
      return std::pow(k, 4) * waveNumberSpectrum(sea, k * std::cos(theta), k * std::sin(theta));
    });
    along += slopes * std::pow(std::cos(theta - sea.windDirection), 2);
    across += slopes * std::pow(std::sin(theta - sea.windDirection), 2);
  }
  const double dTheta = 2 * kPi / kAngles;
  const double wMax = angularFrequency(kMax, sea.depth);
  const double expected = integrate(std::log(0.05), std::log(wMax), 20000,
                                    [&](double x) { return std::exp(x) * frequencySpectrum(sea, std::exp(x)); });
  EXPECT_NEAR(m0 * dTheta / expected, 1, 1e-3);
  EXPECT_NEAR(elevationVariance(sea, 0, kMax) / expected, 1, 1e-3);
  const SlopeVariance slopes = slopeVariance(sea, 0, kMax);
  EXPECT_NEAR(along * dTheta / slopes.upwind, 1, 2e-3);
  EXPECT_NEAR(across * dTheta / slopes.crosswind, 1, 2e-3);
}

TEST(Validation, NamesFieldValueAndRange) {
  SeaState sea;
  sea.windSpeed = -3;
  EXPECT_EQ(validate(sea).error().message, "SeaState::windSpeed is -3, it must lie in 0.1 … 60 m/s");
  sea = {};
  sea.depth = std::nan("");
  ASSERT_FALSE(validate(sea));
  sea = {};
  sea.swell.push_back({1, 0, 0, 10});
  EXPECT_EQ(validate(sea).error().message, "SeaState::swell[0]::peakPeriod is 0, it must lie in 1 … 30 s");
  sea = {};
  sea.octaveGain[3] = -1;
  EXPECT_EQ(validate(sea).error().message, "SeaState::octaveGain[3] is -1, it must lie in 0 … 10");
  sea = {};
  sea.asymmetry = 2.5;
  EXPECT_EQ(validate(sea).error().message, "SeaState::asymmetry is 2.5, it must lie in 0 … 2");
  sea = {};
  sea.swellSharpening = 1.5;
  EXPECT_EQ(validate(sea).error().message, "SeaState::swellSharpening is 1.5, it must lie in 0 … 1");
  sea = {};
  sea.spectrum = static_cast<Spectrum>(77);
  EXPECT_FALSE(validate(sea));
  EXPECT_TRUE(validate(SeaState{}));
}

TEST(RealSea, HasTheMeasuredSlopesAndWhitecaps) {
  const SlopeVariance slopes = coxMunkSlopes(10);
  EXPECT_NEAR(slopes.upwind, 0.0316, 1e-9);
  EXPECT_NEAR(slopes.crosswind, 0.0222, 1e-9);
  EXPECT_NEAR(whitecapFraction(10), 3.84e-6 * std::pow(10, 3.41), 1e-12);
  EXPECT_NEAR(whitecapFraction(4), 3.84e-6 * std::pow(4, 3.41), 1e-12);
  EXPECT_EQ(whitecapFraction(3.6), 0);
}

}  // namespace
