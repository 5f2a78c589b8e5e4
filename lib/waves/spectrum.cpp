#include <algorithm>
#include <cmath>
#include <numbers>
#include <pelagic/spectrum.hpp>
#include <waves/spectrum_table.hpp>
#include <waves/spreading.hpp>
#include <waves/unified.hpp>
#include <waves/wind_and_swell.hpp>

namespace pelagic {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDeep = std::numeric_limits<double>::infinity();
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

/// The wave number of deep water: the real root of (sigma/rho) k^3 + g k = w^2 (Cardano, as Vieta's hyperbolic sine).
double deepWaveNumber(double w) noexcept {
  const double p = kGravity / kCapillarity;
  const double scale = std::sqrt(p / 3);
  return 2 * scale * std::sinh(std::asinh(1.5 * w * w / (kCapillarity * p * scale)) / 3);
}

/// S(w) of the unified spectrum, which is one over wave numbers of deep water. Depth changes the waves' lengths, not
/// the energy of a frequency, as with the other spectra.
double unified(const SeaState& sea, double w) noexcept {
  const double k = deepWaveNumber(w);
  return unifiedSpectrum(unifiedSea(sea.windSpeed, sea.fetch), k) / groupSpeed(k, kDeep);
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
    case Spectrum::elfouhaily:
      return unified(sea, w);
    case Spectrum::table:
      return tableSpectrum(sea.table, w);
  }
  return 0;
}

/// Gain of the energy of waves of one length, SeaState::octaveGain squared [1].
double energyGain(const SeaState& sea, double k) noexcept {
  constexpr double kFirst = 9;  // log2 of the first octave's wavelength
  const double place = std::clamp(kFirst - std::log2(2 * kPi / k), 0.0, static_cast<double>(kOctaves - 1));
  const auto low = std::min(static_cast<std::size_t>(place), kOctaves - 2);
  const double gain = std::lerp(sea.octaveGain[low], sea.octaveGain[low + 1], place - static_cast<double>(low));
  return gain * gain;
}

/// D of the wind sea at one frequency.
class WindDirections {
 public:
  WindDirections(const SeaState& sea, double w) noexcept : sea_(sea), w_(w) {
    if (measured()) return;
    const double peak = peakFrequency(sea);
    SpreadingPoint point{w / peak, sea.windSpeed * peak / kGravity};
    if (sea.spreading == Spreading::elfouhaily) {
      point.asymmetry = unifiedAsymmetry(unifiedSea(sea.windSpeed, sea.fetch), deepWaveNumber(w));
    }
    point.sharpen = 16 * std::tanh(1 / point.relative) * sea.swellSharpening * sea.swellSharpening;
    model_ = directionsAt(sea.spreading, point);
  }
  /// [1/rad]; theta [rad] from the wind.
  double operator()(double theta) const noexcept {
    return measured() ? tableSpreading(sea_.table, w_, theta + sea_.windDirection) : model_(theta);
  }

 private:
  bool measured() const noexcept { return sea_.spectrum == Spectrum::table && !sea_.table.direction.empty(); }
  const SeaState& sea_;
  double w_;
  Directions model_;
};

/// S(w) of everything where the wave number is known.
double spectrumAt(const SeaState& sea, double w, double k) noexcept {
  double sum = windSea(sea, w, k);
  for (const Swell& swell : sea.swell) sum += swellSpectrum(swell, w);
  return sum * energyGain(sea, k);
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

/// Sum over the single trochoids with kMin <= k < kMax of their variance A^2/2 times `weight`.
template <class F>
double sumOfTrochoids(const SeaState& sea, double kMin, double kMax, F weight) noexcept {
  double sum = 0;
  for (const Trochoid& wave : sea.trochoids) {
    const double k = 2 * kPi / wave.wavelength;
    if (k >= kMin && k < kMax) sum += 0.5 * wave.amplitude * wave.amplitude * weight(wave, k);
  }
  return sum;
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
    case Spectrum::elfouhaily:
      return angularFrequency(unifiedSea(sea.windSpeed, sea.fetch).peakWaveNumber, kDeep);
    case Spectrum::table:
      return tablePeak(sea.table);
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
  return w > 0 ? spectrumAt(sea, w, waveNumberOf(w, sea.depth)) : 0;
}

double windSeaSpreading(const SeaState& sea, double w, double theta) noexcept { return WindDirections(sea, w)(theta); }

WindAndSwell waveNumberSpectra(const SeaState& sea, double kx, double kz) noexcept {
  const double k = std::hypot(kx, kz);
  if (!(k > 0)) return {};
  const double w = angularFrequency(k, sea.depth);
  const double direction = std::atan2(kz, kx);
  const double scale = energyGain(sea, k) * groupSpeed(k, sea.depth) / k;
  WindAndSwell sum{windSea(sea, w, k) * windSeaSpreading(sea, w, direction - sea.windDirection) * scale, 0};
  for (const Swell& swell : sea.swell) {
    sum.swell += swellSpectrum(swell, w) * cosinePower(swell.spread, direction - swell.direction) * scale;
  }
  return sum;
}

double waveNumberSpectrum(const SeaState& sea, double kx, double kz) noexcept {
  const WindAndSwell spectra = waveNumberSpectra(sea, kx, kz);
  return spectra.wind + spectra.swell;
}

double elevationVariance(const SeaState& sea, double kMin, double kMax) noexcept {
  const double continuous = integrateOverWaveNumber(kMin, kMax, [&](double k) {
    return spectrumAt(sea, angularFrequency(k, sea.depth), k) * groupSpeed(k, sea.depth);
  });
  return continuous + sumOfTrochoids(sea, kMin, kMax, [](const Trochoid&, double) { return 1.0; });
}

SlopeVariance slopeVariance(const SeaState& sea, double kMin, double kMax) noexcept {
  const auto slopes = [&](double k, double density) {
    return k * k * groupSpeed(k, sea.depth) * energyGain(sea, k) * density;
  };
  SlopeVariance result;
  const auto add = [&](const auto& density, const auto& share) {
    const auto along = [&](double k) { return density(angularFrequency(k, sea.depth), k) * share(k); };
    const double up = integrateOverWaveNumber(kMin, kMax, [&](double k) { return slopes(k, along(k)); });
    const double all = integrateOverWaveNumber(
        kMin, kMax, [&](double k) { return slopes(k, density(angularFrequency(k, sea.depth), k)); });
    result.upwind += up;
    result.crosswind += all - up;
  };
  add([&](double w, double k) { return windSea(sea, w, k); },
      [&](double k) { return alongShare(WindDirections(sea, angularFrequency(k, sea.depth))); });
  for (const Swell& swell : sea.swell) {
    const double share = alongShare(
        [&](double theta) { return cosinePower(swell.spread, theta - (swell.direction - sea.windDirection)); });
    add([&](double w, double) { return swellSpectrum(swell, w); }, [&](double) { return share; });
  }
  const auto along = [&](const Trochoid& wave) { return std::cos(wave.direction - sea.windDirection); };
  const auto across = [&](const Trochoid& wave) { return std::sin(wave.direction - sea.windDirection); };
  result.upwind += sumOfTrochoids(sea, kMin, kMax,
                                  [&](const Trochoid& wave, double k) { return k * k * along(wave) * along(wave); });
  result.crosswind += sumOfTrochoids(
      sea, kMin, kMax, [&](const Trochoid& wave, double k) { return k * k * across(wave) * across(wave); });
  return result;
}

double significantWaveHeight(const SeaState& sea) noexcept { return 4 * std::sqrt(elevationVariance(sea, 0, 1e4)); }

double zeroCrossingPeriod(const SeaState& sea) noexcept {
  const double m2 = integrateOverWaveNumber(0, 1e4,
                                            [&](double k) {
                                              const double w = angularFrequency(k, sea.depth);
                                              return w * w * spectrumAt(sea, w, k) * groupSpeed(k, sea.depth);
                                            }) +
                    sumOfTrochoids(sea, 0, 1e4, [&](const Trochoid&, double k) {
                      return std::pow(angularFrequency(k, sea.depth), 2);
                    });
  return 2 * kPi * std::sqrt(elevationVariance(sea, 0, 1e4) / m2);
}

double peakPeriod(const SeaState& sea) noexcept {
  double best = peakFrequency(sea);
  for (const Swell& swell : sea.swell) {
    const double w = 2 * kPi / swell.peakPeriod;
    if (frequencySpectrum(sea, w) > frequencySpectrum(sea, best)) best = w;
  }
  return 2 * kPi / best;
}

double longestPeakWavelength(const SeaState& sea) noexcept {
  double lowest = sea.spectrum == Spectrum::table ? tableLongestPeak(sea.table) : peakFrequency(sea);
  for (const Swell& swell : sea.swell) lowest = std::min(lowest, 2 * kPi / swell.peakPeriod);
  double longest = 2 * kPi / waveNumberOf(lowest, sea.depth);
  for (const Trochoid& wave : sea.trochoids) longest = std::max(longest, wave.wavelength);
  return longest;
}

SlopeVariance coxMunkSlopes(double windSpeed) noexcept { return {0.00316 * windSpeed, 0.003 + 0.00192 * windSpeed}; }

double coxMunkSkewness(double windSpeed) noexcept { return std::min(0.0, 0.04 - 0.033 * std::min(windSpeed, 14.0)); }

double whitecapFraction(double windSpeed) noexcept {
  constexpr double kFirstWhitecaps = 3.7;  // m/s
  return windSpeed < kFirstWhitecaps ? 0 : std::min(1.0, 3.84e-6 * std::pow(windSpeed, 3.41));
}

}  // namespace pelagic
