#include <cmath>
#include <complex>
#include <numbers>
#include <waves/closure.hpp>
#include <waves/lean.hpp>
#include <waves/modes.hpp>
#include <waves/wind_and_swell.hpp>

namespace pelagic {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

/// Finaliser of SplitMix64 (Steele, Lea & Flood 2014): a bijection whose output bits all depend on all input bits.
std::uint64_t mix(std::uint64_t x) noexcept {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// (xi1 + i xi2)/sqrt(2) with xi standard normal, by Box & Muller; of (seed, cascade, mode) alone.
std::complex<double> randomAmplitude(std::uint64_t seed, std::uint32_t cascade, int mx, int mz) noexcept {
  const auto mode = static_cast<std::uint64_t>(static_cast<std::uint32_t>(mx)) << 32 | static_cast<std::uint32_t>(mz);
  const std::uint64_t a = mix(mix(mix(seed) + cascade) ^ mode);
  const std::uint64_t b = mix(a);
  constexpr double kUnit = 0x1p-53;
  const double u1 = (static_cast<double>(a >> 11) + 1) * kUnit;  // (0, 1]
  const double u2 = static_cast<double>(b >> 11) * kUnit;        // [0, 1)
  return std::polar(std::sqrt(-std::log(u1)), kTwoPi * u2);
}

/// A wave of its own takes the place of the random ones of a pair of modes.
void putTrochoid(const GridTrochoid& trochoid, std::uint32_t n, CascadeModes& modes) {
  const Trochoid& wave = trochoid.wave;
  const auto indexOf = [&](int mx, int mz) {
    const auto row = static_cast<std::uint32_t>(mz) & (n - 1), column = static_cast<std::uint32_t>(mx) & (n - 1);
    return std::size_t{row} * n + column;
  };
  const std::size_t index = indexOf(trochoid.mx, trochoid.mz);
  const std::size_t opposite = indexOf(-trochoid.mx, -trochoid.mz);
  const glm::vec2 half(glm::dvec2(std::cos(wave.phase), std::sin(wave.phase)) * (0.5 * wave.amplitude));
  modes.amplitude[index] = glm::vec4(half, 0, 0);
  modes.amplitude[opposite] = glm::vec4(0, 0, half.x, -half.y);
  for (const std::size_t mode : {index, opposite}) {
    modes.variance[mode] = 0.25 * wave.amplitude * wave.amplitude;
    modes.constants[mode].chop = {static_cast<float>(wave.steepness * wave.wavelength / kTwoPi), 0};
  }
}

}  // namespace

int modeOf(std::uint32_t i, std::uint32_t size) noexcept {
  return static_cast<int>(i) - (i >= size / 2 ? static_cast<int>(size) : 0);
}

CascadeModes makeModes(const SeaState& sea, const WaveLayout& layout, std::uint32_t cascade, double loopPeriod) {
  return makeModes(sea, layout, cascade, loopPeriod, trochoidsOnGrid(sea, layout, 0));
}

CascadeModes makeModes(const SeaState& sea, const WaveLayout& layout, std::uint32_t cascade, double loopPeriod,
                       const GridTrochoids& trochoids) {
  const std::uint32_t n = layout.size;
  const Cascade& patch = layout.cascades[cascade];
  const double dk = kTwoPi / patch.length;
  const std::size_t total = static_cast<std::size_t>(n) * n;

  std::vector<double> energy(total, 0.0);  // Psi(k) dk^2
  std::vector<double> ofWind(total, 0.0);  // the wind sea's part of it
  const double lean = leanWithWind(sea);
  CascadeModes modes;
  modes.amplitude.assign(total, glm::vec4(0));
  modes.constants.assign(total, {});
  modes.variance.assign(total, 0.0);
  const double kMax = std::fmin(patch.kMax, shortestWaveNumber(sea));
  const auto exists = [&](std::uint32_t row, std::uint32_t column) {
    if (row == n / 2 || column == n / 2) return false;
    const double k = dk * std::hypot(modeOf(column, n), modeOf(row, n));
    return k > 0 && k >= patch.kMin && k < kMax;
  };
  for (std::uint32_t row = 0; row < n; ++row) {
    for (std::uint32_t column = 0; column < n; ++column) {
      if (!exists(row, column)) continue;
      const double kx = dk * modeOf(column, n);
      const double kz = dk * modeOf(row, n);
      const double kept = std::hypot(kx, kz) < trochoids.cut ? trochoids.kept : 1;
      const WindAndSwell spectra = waveNumberSpectra(sea, kx, kz);
      energy[row * n + column] = kept * (spectra.wind + spectra.swell) * dk * dk;
      ofWind[row * n + column] = kept * spectra.wind * dk * dk;
    }
  }
  for (std::uint32_t row = 0; row < n; ++row) {
    for (std::uint32_t column = 0; column < n; ++column) {
      if (!exists(row, column)) continue;
      const std::size_t index = static_cast<std::size_t>(row) * n + column;
      const std::size_t opposite = static_cast<std::size_t>((n - row) % n) * n + (n - column) % n;
      const int mx = modeOf(column, n);
      const int mz = modeOf(row, n);
      const auto forward = randomAmplitude(sea.seed, cascade, mx, mz) * std::sqrt(0.5 * energy[index]);
      const auto backward = std::conj(randomAmplitude(sea.seed, cascade, -mx, -mz)) * std::sqrt(0.5 * energy[opposite]);
      modes.amplitude[index] = glm::vec4(glm::dvec4(forward.real(), forward.imag(), backward.real(), backward.imag()));
      modes.variance[index] = 0.5 * (energy[index] + energy[opposite]);
      const double k = dk * std::hypot(mx, mz);
      const double cycles = std::round(angularFrequency(k, sea.depth) * loopPeriod / kTwoPi);
      // Both waves of a pair lean with the wind: the phase turns its sign with k.
      const double both = energy[index] + energy[opposite];
      const double windShare = both > 0 ? (ofWind[index] + ofWind[opposite]) / both : 0;
      const double angle = lean * windShare * std::cos(std::atan2(mz, mx) - sea.windDirection);
      const double chop = sea.choppiness / (std::tanh(k * sea.depth) * k);
      modes.constants[index] = {static_cast<std::uint32_t>(std::fmax(1, cycles)),
                                glm::vec2(glm::dvec2(std::cos(angle), -std::sin(angle)) * chop)};
    }
  }
  for (const GridTrochoid& trochoid : trochoids.waves) {
    if (trochoid.cascade == cascade) putTrochoid(trochoid, n, modes);
  }
  return modes;
}

std::uint64_t loopFraction(double time, double loopPeriod) noexcept {
  double rest = std::fmod(time, loopPeriod);  // exact
  if (rest < 0) rest += loopPeriod;
  const double fraction = rest / loopPeriod;
  return fraction < 1 ? static_cast<std::uint64_t>(std::ldexp(fraction, 64)) : 0;
}

CascadeMoments momentsOf(const CascadeModes& modes, const Cascade& cascade, std::uint32_t size) {
  CascadeMoments sum;
  const double dk = kTwoPi / cascade.length;
  for (std::uint32_t row = 0; row < size; ++row) {
    for (std::uint32_t column = 0; column < size; ++column) {
      const std::size_t mode = static_cast<std::size_t>(row) * size + column;
      const double variance = modes.variance[mode];
      const double chop = glm::length(glm::dvec2(modes.constants[mode].chop));
      const double kx = dk * modeOf(column, size);
      const double kz = dk * modeOf(row, size);
      sum.elevation += variance;
      sum.horizontal += variance * chop * chop * (kx * kx + kz * kz);
      sum.slopes += variance * glm::dvec3(kx * kx, kz * kz, kx * kz);
    }
  }
  return sum;
}

}  // namespace pelagic
