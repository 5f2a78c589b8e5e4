#include <algorithm>
#include <cmath>
#include <numbers>
#include <pelagic/spectrum.hpp>
#include <waves/spreading.hpp>

namespace pelagic {
namespace {

constexpr double kPi = std::numbers::pi;
/// Surface tension over density of clean sea water [m^3/s^2].
constexpr double kCapillarity = 7.4e-5;
/// Pierson & Moskowitz (1964): S = alpha g^2 w^-5 exp(-beta (w0/w)^4), w0 = g / U19.5.
constexpr double kPmAlpha = 8.1e-3;
constexpr double kPmBeta = 0.74;
/// U19.5 / U10 of the neutral logarithmic wind profile.
constexpr double kWindRatio = 1.026;
/// Dimensionless fetch g F / U10^2 where JONSWAP's m0 reaches Pierson-Moskowitz's: the sea is fully developed.
constexpr double kFullyDeveloped = 1.07e4;
/// Peakedness of a swell train's spectrum, lambda of Ochi & Hubble (1976).
constexpr double kSwellShape = 4;

double pmFrequency(const SeaState& sea) noexcept { return kGravity / (kWindRatio * sea.windSpeed); }

double effectiveFetch(const SeaState& sea) noexcept {
  return std::min(sea.fetch, kFullyDeveloped * sea.windSpeed * sea.windSpeed / kGravity);
}

double jonswap(const SeaState& sea, double w) noexcept {
  const double alpha = 0.076 * std::pow(sea.windSpeed * sea.windSpeed / (effectiveFetch(sea) * kGravity), 0.22);
  const double peak = peakFrequency(sea);
  const double sigma = w <= peak ? 0.07 : 0.09;
  const double d = (w - peak) / (sigma * peak);
  const double enhancement = std::pow(3.3, std::exp(-0.5 * d * d));
  return alpha * kGravity * kGravity * std::pow(w, -5) * std::exp(-1.25 * std::pow(peak / w, 4)) * enhancement;
}

double piersonMoskowitz(const SeaState& sea, double w) noexcept {
  return kPmAlpha * kGravity * kGravity * std::pow(w, -5) * std::exp(-kPmBeta * std::pow(pmFrequency(sea) / w, 4));
}

/// Tessendorf's exp(-1/(kL)^2)/k^4, L = U^2/g, as S(w) of deep water; its variance is set to Pierson-Moskowitz's.
double phillips(const SeaState& sea, double w) noexcept {
  const double variance = kPmAlpha * kGravity * kGravity / (4 * kPmBeta * std::pow(pmFrequency(sea), 4));
  const double w1 = kGravity / sea.windSpeed;
  const double ratio4 = std::pow(w1 / w, 4);
  return 4 * variance * ratio4 / w * std::exp(-ratio4);
}

/// Kitaigorodskii's factor for wind seas in depth h, from kh (Bouws et al. 1985).
double depthFactor(double kh) noexcept {
  const double t = std::tanh(kh);
  // 2kh/sinh(2kh) vanishes long before sinh overflows.
  const double u = kh < 300 ? 2 * kh / std::sinh(2 * kh) : 0;
  return t * t / (1 + u);
}

/// Wind sea at a frequency whose wave number is known.
double windSea(const SeaState& sea, double w, double k) noexcept {
  switch (sea.spectrum) {
    case Spectrum::phillips:
      return phillips(sea, w);
    case Spectrum::piersonMoskowitz:
      return piersonMoskowitz(sea, w);
    case Spectrum::jonswap:
      return jonswap(sea, w);
    case Spectrum::tma:
      return jonswap(sea, w) * depthFactor(k * sea.depth);
  }
  return 0;
}

/// Integral over ln k of f(k) by Simpson's rule; the ends stand for 0 and infinity, outside them no sea has energy.
template <class F>
double integrateOverWaveNumber(double kMin, double kMax, F f) noexcept {
  const double a = std::log(std::max(kMin, 1e-6));
  const double b = std::log(std::min(kMax, 1e4));
  if (!(b > a)) return 0;
  // Fine enough for JONSWAP's peak, 0.14 wide in ln k.
  const int n = 2 * std::max(64, static_cast<int>(std::ceil((b - a) / 0.01)));
  const double step = (b - a) / n;
  double sum = 0;
  for (int i = 0; i <= n; ++i) {
    const double weight = i == 0 || i == n ? 1 : (i % 2 ? 4 : 2);
    const double k = std::exp(a + step * i);
    sum += weight * k * f(k);
  }
  return sum * step / 3;
}

/// Integral of D cos^2 over all angles, the share of a spreading function's slopes along theta = 0.
template <class F>
double alongShare(F distribution) noexcept {
  constexpr int kSteps = 256;  // trapezium rule on a periodic function; the narrowest train is 0.1 rad wide
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double theta = 2 * kPi * i / kSteps;
    const double c = std::cos(theta);
    sum += distribution(theta) * c * c;
  }
  return sum * 2 * kPi / kSteps;
}

}  // namespace

double angularFrequency(double waveNumber, double depth) noexcept {
  const double k = waveNumber;
  return std::sqrt((kGravity * k + kCapillarity * k * k * k) * std::tanh(k * depth));
}

double groupSpeed(double waveNumber, double depth) noexcept {
  const double k = waveNumber;
  const double kh = k * depth;
  const double w = angularFrequency(k, depth);
  double slope = (kGravity + 3 * kCapillarity * k * k) * std::tanh(kh);
  if (kh < 300) {
    const double c = std::cosh(kh);
    slope += (kGravity * k + kCapillarity * k * k * k) * depth / (c * c);
  }
  return slope / (2 * w);
}

double waveNumberOf(double angularFrequencyWanted, double depth) noexcept {
  const double w = angularFrequencyWanted;
  // w(k) rises monotonically from 0; capillarity only lowers k below w^2/g and depth raises it.
  double low = 0;
  double high = w * w / kGravity;
  while (angularFrequency(high, depth) < w) high *= 2;
  for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (angularFrequency(middle, depth) < w ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double peakFrequency(const SeaState& sea) noexcept {
  switch (sea.spectrum) {
    case Spectrum::phillips:
      return std::pow(0.8, 0.25) * kGravity / sea.windSpeed;
    case Spectrum::piersonMoskowitz:
      return std::pow(0.8 * kPmBeta, 0.25) * pmFrequency(sea);
    case Spectrum::jonswap:
    case Spectrum::tma:
      return 22 * std::cbrt(kGravity * kGravity / (sea.windSpeed * effectiveFetch(sea)));
  }
  return 0;
}

double windSeaSpectrum(const SeaState& sea, double w) noexcept {
  if (!(w > 0)) return 0;
  return windSea(sea, w, sea.spectrum == Spectrum::tma ? waveNumberOf(w, sea.depth) : 0);
}

double swellSpectrum(const Swell& swell, double w) noexcept {
  if (!(w > 0)) return 0;
  const double peak = 2 * kPi / swell.peakPeriod;
  const double a = kSwellShape + 0.25;
  const double ratio4 = std::pow(peak / w, 4);
  const double hs = swell.significantHeight;
  // Ochi & Hubble (1976) eq. 2: integral Hs^2/16.
  return 0.25 * hs * hs * std::pow(a * ratio4, kSwellShape) * std::exp(-a * ratio4) / (std::tgamma(kSwellShape) * w);
}

double frequencySpectrum(const SeaState& sea, double w) noexcept {
  double sum = windSeaSpectrum(sea, w);
  for (const Swell& swell : sea.swell) sum += swellSpectrum(swell, w);
  return sum;
}

double windSeaSpreading(const SeaState& sea, double w, double theta) noexcept {
  const double peak = peakFrequency(sea);
  return spreading(sea.spreading, w / peak, sea.windSpeed * peak / kGravity, theta);
}

double waveNumberSpectrum(const SeaState& sea, double kx, double kz) noexcept {
  const double k = std::hypot(kx, kz);
  if (!(k > 0)) return 0;
  const double w = angularFrequency(k, sea.depth);
  const double direction = std::atan2(kz, kx);
  double sum = windSea(sea, w, k) * windSeaSpreading(sea, w, direction - sea.windDirection);
  for (const Swell& swell : sea.swell) {
    sum += swellSpectrum(swell, w) * cosinePower(swell.spread, direction - swell.direction);
  }
  return sum * groupSpeed(k, sea.depth) / k;
}

double elevationVariance(const SeaState& sea, double kMin, double kMax) noexcept {
  return integrateOverWaveNumber(kMin, kMax, [&](double k) {
    const double w = angularFrequency(k, sea.depth);
    double s = windSea(sea, w, k);
    for (const Swell& swell : sea.swell) s += swellSpectrum(swell, w);
    return s * groupSpeed(k, sea.depth);
  });
}

SlopeVariance slopeVariance(const SeaState& sea, double kMin, double kMax) noexcept {
  double total = 0;
  const double along = integrateOverWaveNumber(kMin, kMax, [&](double k) {
    const double w = angularFrequency(k, sea.depth);
    const double wind = windSea(sea, w, k);
    return k * k * groupSpeed(k, sea.depth) * wind *
           alongShare([&](double theta) { return windSeaSpreading(sea, w, theta); });
  });
  total += integrateOverWaveNumber(kMin, kMax, [&](double k) {
    return k * k * groupSpeed(k, sea.depth) * windSea(sea, angularFrequency(k, sea.depth), k);
  });
  SlopeVariance result{along, total - along};
  for (const Swell& swell : sea.swell) {
    const double train = integrateOverWaveNumber(kMin, kMax, [&](double k) {
      return k * k * groupSpeed(k, sea.depth) * swellSpectrum(swell, angularFrequency(k, sea.depth));
    });
    const double share = alongShare(
        [&](double theta) { return cosinePower(swell.spread, theta - (swell.direction - sea.windDirection)); });
    result.upwind += train * share;
    result.crosswind += train * (1 - share);
  }
  return result;
}

double significantWaveHeight(const SeaState& sea) noexcept { return 4 * std::sqrt(elevationVariance(sea, 0, 1e4)); }

double peakPeriod(const SeaState& sea) noexcept {
  double best = peakFrequency(sea);
  for (const Swell& swell : sea.swell) {
    const double w = 2 * kPi / swell.peakPeriod;
    if (frequencySpectrum(sea, w) > frequencySpectrum(sea, best)) best = w;
  }
  return 2 * kPi / best;
}

double longestPeakWavelength(const SeaState& sea) noexcept {
  double lowest = peakFrequency(sea);
  for (const Swell& swell : sea.swell) lowest = std::min(lowest, 2 * kPi / swell.peakPeriod);
  return 2 * kPi / waveNumberOf(lowest, sea.depth);
}

SlopeVariance coxMunkSlopes(double windSpeed) noexcept { return {0.00316 * windSpeed, 0.003 + 0.00192 * windSpeed}; }

double whitecapFraction(double windSpeed) noexcept { return std::min(1.0, 3.84e-6 * std::pow(windSpeed, 3.41)); }

}  // namespace pelagic
