#include <algorithm>
#include <cmath>
#include <gpu/context.hpp>
#include <numbers>
#include <optional>
#include <set>
#include <sstream>
#include <waves/trochoids.hpp>
#include <waves/warp.hpp>

namespace pelagic {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;
/// Share of the elevation's variance, from the longest waves on, that picked trochoids stand for: the rest lies in a
/// tail of short waves that no few trochoids could draw.
constexpr double kPickedShare = 0.95;

double waveNumber(const Trochoid& wave) noexcept { return kTwoPi / wave.wavelength; }

/// Smallest number whose cumulated density is `share` of the whole, where cumulated[i] belongs to places[i].
double quantile(const std::vector<double>& places, const std::vector<double>& cumulated, double share) noexcept {
  const double wanted = share * cumulated.back();
  const auto next = std::lower_bound(cumulated.begin() + 1, cumulated.end() - 1, wanted);
  const auto i = static_cast<std::size_t>(next - cumulated.begin());
  const double rise = cumulated[i] - cumulated[i - 1];
  const double part = rise > 0 ? std::clamp((wanted - cumulated[i - 1]) / rise, 0.0, 1.0) : 0;
  return places[i - 1] + part * (places[i] - places[i - 1]);
}

/// Variance of the elevation by wave number, over what the layout holds.
struct Energy {
  std::vector<double> waveNumbers;
  std::vector<double> cumulated;  ///< [m^2]
};

Energy energyOf(const SeaState& sea, const WaveLayout& layout) {
  constexpr int kSteps = 1024;
  const double low = kTwoPi / layout.cascades[0].length;
  const double high = layout.cascades[layout.count - 1].kMax;
  Energy energy;
  double before = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double k = low * std::pow(high / low, static_cast<double>(i) / kSteps);
    const double density = frequencySpectrum(sea, angularFrequency(k, sea.depth)) * groupSpeed(k, sea.depth);
    const double sum =
        i == 0 ? 0 : energy.cumulated.back() + 0.5 * (density + before) * (k - energy.waveNumbers.back());
    energy.waveNumbers.push_back(k);
    energy.cumulated.push_back(sum);
    before = density;
  }
  return energy;
}

/// Direction below which `share` of the energy of wave number k goes, from -pi.
double directionQuantile(const SeaState& sea, double k, double share) {
  constexpr int kSteps = 360;
  std::vector<double> angles, cumulated;
  double sum = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double angle = kTwoPi * i / kSteps - std::numbers::pi;
    if (i > 0) {
      const double middle = angle - std::numbers::pi / kSteps;
      sum += waveNumberSpectrum(sea, k * std::cos(middle), k * std::sin(middle));
    }
    angles.push_back(angle);
    cumulated.push_back(sum);
  }
  return quantile(angles, cumulated, share);
}

/// Adds trochoids of equal energy, one from each of as many equal parts of the spectrum.
void pick(const SeaState& sea, const WaveLayout& layout, std::vector<Trochoid>& waves, GridTrochoids& grid) {
  const TrochoidPick& wanted = sea.trochoidPick;
  const Energy energy = energyOf(sea, layout);
  const double variance = kPickedShare * energy.cumulated.back();
  const double amplitude = std::sqrt(2 * (1 - wanted.roughness) * variance / wanted.count);
  // Nothing to draw: all stays random, or the sea is as good as still.
  constexpr double kLeastAmplitude = 1e-6;  // [m]
  if (!(amplitude > kLeastAmplitude)) return;
  grid.cut = quantile(energy.waveNumbers, energy.cumulated, kPickedShare);
  grid.kept = wanted.roughness;
  // Steps of the golden ratio spread directions and phases evenly, however many there are; the seed turns them.
  const double golden = std::numbers::phi - 1;
  const double start = std::fmod(static_cast<double>(sea.seed % 1000003) * golden, 1.0);
  for (std::uint32_t i = 0; i < wanted.count; ++i) {
    const double middle = (i + 0.5) / wanted.count;
    const double k = quantile(energy.waveNumbers, energy.cumulated, kPickedShare * middle);
    Trochoid wave;
    wave.amplitude = amplitude;
    wave.wavelength = kTwoPi / k;
    wave.direction = directionQuantile(sea, k, std::fmod(start + i * golden, 1.0));
    wave.phase = kTwoPi * std::fmod(start + i * golden * golden * 7, 1.0);
    wave.steepness = wanted.steepness / (wanted.count * k * amplitude);
    waves.push_back(wave);
  }
}

/// Puts a wave on the nearest mode of its cascade that no other holds, if there is one.
std::optional<GridTrochoid> place(const Trochoid& wave, const WaveLayout& layout, std::set<std::array<int, 3>>& taken) {
  const double k = waveNumber(wave);
  GridTrochoid placed;
  placed.wave = wave;
  while (placed.cascade + 1 < layout.count && k >= layout.cascades[placed.cascade].kMax) ++placed.cascade;
  const Cascade& cascade = layout.cascades[placed.cascade];
  const auto owner = static_cast<int>(placed.cascade);
  const double dk = kTwoPi / cascade.length;
  const int most = static_cast<int>(layout.size) / 2 - 1;
  // A wave number beyond the lattice is sought from its corner.
  const double x = std::clamp(k / dk * std::cos(wave.direction), -1.0 * most, 1.0 * most);
  const double z = std::clamp(k / dk * std::sin(wave.direction), -1.0 * most, 1.0 * most);
  double nearest = HUGE_VAL;
  // A ring that is farther away than what was found cannot hold anything nearer.
  for (int reach = 4; reach <= 2 * most && nearest > reach - 1; reach *= 2) {
    for (int mz = std::max(-most, static_cast<int>(z) - reach); mz <= std::min(most, static_cast<int>(z) + reach);
         ++mz) {
      for (int mx = std::max(-most, static_cast<int>(x) - reach); mx <= std::min(most, static_cast<int>(x) + reach);
           ++mx) {
        const double length = dk * std::hypot(mx, mz);
        const double distance = std::hypot(mx - x, mz - z);
        if (!(length > 0) || length < cascade.kMin || length >= cascade.kMax || distance >= nearest) continue;
        if (taken.count({owner, mx, mz}) != 0) continue;
        nearest = distance;
        placed.mx = mx;
        placed.mz = mz;
      }
    }
  }
  if (!std::isfinite(nearest)) return {};
  taken.insert({owner, placed.mx, placed.mz});
  taken.insert({owner, -placed.mx, -placed.mz});  // the same pair of modes
  placed.wave.wavelength = kTwoPi / (dk * std::hypot(placed.mx, placed.mz));
  placed.wave.direction = std::atan2(placed.mz, placed.mx);
  return placed;
}

/// The wave inherits the energy of the random waves whose modes it takes; it stays as sharp.
void inherit(const SeaState& sea, const WaveLayout& layout, double kept, GridTrochoid& placed) {
  const double dk = kTwoPi / layout.cascades[placed.cascade].length;
  const double kx = dk * placed.mx, kz = dk * placed.mz;
  const double energy = kept * dk * dk * (waveNumberSpectrum(sea, kx, kz) + waveNumberSpectrum(sea, -kx, -kz));
  Trochoid& wave = placed.wave;
  const double amplitude = std::sqrt(wave.amplitude * wave.amplitude + 2 * energy);
  wave.steepness *= wave.amplitude / amplitude;
  wave.amplitude = amplitude;
}

}  // namespace

Result<void> validate(const SeaState& sea, const WaveLayout& layout) {
  const double longest = layout.cascades[0].length;
  const double shortest = kTwoPi / layout.cascades[layout.count - 1].kMax;
  for (std::size_t i = 0; i < sea.trochoids.size(); ++i) {
    const double wavelength = sea.trochoids[i].wavelength;
    if (wavelength > shortest && wavelength <= longest) continue;
    std::ostringstream text;
    text << "SeaState::trochoids[" << i << "]::wavelength is " << wavelength
         << ", the patches of this layout hold more than " << shortest << " to " << longest << " m";
    return gpu::reject(text.str());
  }
  std::set<std::array<int, 3>> taken;
  for (std::size_t i = 0; i < sea.trochoids.size(); ++i) {
    if (place(sea.trochoids[i], layout, taken)) continue;
    return gpu::reject("SeaState::trochoids[" + std::to_string(i) +
                       "] finds no free mode in its cascade of this layout: others hold them all");
  }
  return {};
}

GridTrochoids trochoidsOnGrid(const SeaState& sea, const WaveLayout& layout, double warp) {
  GridTrochoids grid;
  std::vector<Trochoid> waves = sea.trochoids;
  if (sea.trochoidPick.count > 0) pick(sea, layout, waves, grid);
  std::set<std::array<int, 3>> taken;
  double steepest = 0;
  for (std::size_t i = 0; i < waves.size(); ++i) {
    std::optional<GridTrochoid> found = place(waves[i], layout, taken);
    if (!found) continue;
    if (i >= sea.trochoids.size()) inherit(sea, layout, grid.kept, *found);
    grid.waves.push_back(*found);
    const Trochoid& placed = found->wave;
    steepest += placed.steepness * waveNumber(placed) * placed.amplitude;
  }
  // No loops while the sum of Q k A is at most 1 (Finch 2004, GPU Gems 1), with the k where the warp is tightest.
  steepest *= 1 + kLargestStretch * warp;
  if (steepest > 1) grid.steepnessScale = 1 / steepest;
  for (GridTrochoid& placed : grid.waves) placed.wave.steepness *= grid.steepnessScale;
  return grid;
}

}  // namespace pelagic
