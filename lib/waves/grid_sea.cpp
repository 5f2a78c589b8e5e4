#include <algorithm>
#include <cmath>
#include <gpu/context.hpp>
#include <numbers>
#include <sstream>
#include <waves/closure.hpp>
#include <waves/grid_sea.hpp>
#include <waves/interpolation.hpp>
#include <waves/peak.hpp>
#include <waves/trochoids.hpp>
#include <waves/whitecaps.hpp>

namespace pelagic {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;
/// Waves that break into foam that stays for seconds are longer than this [m]. A breaker's foam fades within a few of
/// its wave's periods, 1.6 s here, and the maps keep all foam for kFoamLifetime: that of shorter waves would be a film
/// all over.
constexpr double kShortestFoamingWave = 4;
/// Largest wave number of a layout [rad/m]: 0.6 mm.
constexpr double kShortestWave = 1e4;

template <class T>
tl::unexpected<Error> rejectField(const std::string& field, T value, const char* range) {
  std::ostringstream text;
  text << field << " is " << value << ", it must " << range;
  return gpu::reject(text.str());
}

Result<void> validate(const WaveLayout& layout, double loopPeriod) {
  if (layout.size < 64 || layout.size > 1024 || (layout.size & (layout.size - 1)) != 0) {
    return rejectField("WaveLayout::size", layout.size, "be a power of two in 64 … 1024");
  }
  if (layout.count < 1 || layout.count > kMaxCascades) {
    return rejectField("WaveLayout::count", layout.count, "lie in 1 … 8");
  }
  double inner = 0;
  for (std::uint32_t c = 0; c < layout.count; ++c) {
    const Cascade& cascade = layout.cascades[c];
    const std::string name = "WaveLayout::cascades[" + std::to_string(c) + "]::";
    if (!(cascade.length >= 0.01 && cascade.length <= 1e6)) {
      return rejectField(name + "length", cascade.length, "lie in 0.01 … 1e6 m");
    }
    if (c > 0 && cascade.length > layout.cascades[c - 1].length) {
      return rejectField(name + "length", cascade.length, "not exceed the length of the cascade before");
    }
    if (!(cascade.kMin >= inner && cascade.kMin <= kShortestWave)) {
      return rejectField(name + "kMin", cascade.kMin, "be at least kMax of the cascade before, and at most 1e4 rad/m");
    }
    if (!(cascade.kMax > cascade.kMin && cascade.kMax <= kShortestWave)) {
      return rejectField(name + "kMax", cascade.kMax, "exceed kMin, and be at most 1e4 rad/m");
    }
    inner = cascade.kMax;
  }
  // Every mode turns n times per loop period, n a 32-bit number. Deep water is the fastest.
  const double highest = angularFrequency(inner, std::numeric_limits<double>::infinity()) * loopPeriod / kTwoPi;
  if (!(highest < 0x1p32)) {
    return rejectField("WavesInfo::loopPeriod", loopPeriod,
                       "be short enough that the shortest wave has less than 2^32 periods in it");
  }
  return {};
}

SlopeVariance alongWind(const glm::dvec3& covariance, double direction) noexcept {
  const double c = std::cos(direction);
  const double s = std::sin(direction);
  const double up = covariance.x * c * c + covariance.y * s * s + 2 * covariance.z * c * s;
  return {up, covariance.x + covariance.y - up};
}

/// The elevation is scaled to about the size of the slopes that share its transform.
float heightScale(const CascadeMoments& moments) noexcept {
  const double slopes = moments.slopes.x + moments.slopes.y;
  if (!(slopes > 0 && moments.elevation > 0)) return 1;
  return static_cast<float>(std::exp2(std::round(0.5 * std::log2(slopes / moments.elevation))));
}

/// Largest relative change of a frequency by its rounding to cycles per loop.
double frequencyError(const CascadeModes& modes, const Cascade& cascade, std::uint32_t size, double depth,
                      double loopPeriod) noexcept {
  const double dk = kTwoPi / cascade.length;
  double worst = 0;
  for (std::uint32_t row = 0; row <= size / 2; ++row) {
    for (std::uint32_t column = 0; column <= size / 2; ++column) {
      const std::uint32_t cycles = modes.constants[static_cast<std::size_t>(row) * size + column].cycles;
      if (cycles == 0) continue;
      const double w = angularFrequency(dk * std::hypot(row, column), depth);
      worst = std::max(worst, std::abs(kTwoPi * cycles / (loopPeriod * w) - 1));
    }
  }
  return worst;
}

}  // namespace

double elevationDeviation(const SeaMoments& moments) noexcept {
  return std::max(std::sqrt(moments.elevation), moments.trochoidHeight / 6);
}

double horizontalDeviation(const SeaMoments& moments) noexcept {
  return std::max(std::sqrt(moments.horizontal), moments.trochoidReach / 6);
}

Result<void> validate(const WavesInfo& info) {
  PELAGIC_CHECK(validate(info.sea));
  if (!(info.loopPeriod >= 1 && info.loopPeriod <= 4194304)) {
    return rejectField("WavesInfo::loopPeriod", info.loopPeriod, "lie in 1 … 4194304 s");
  }
  PELAGIC_CHECK(validate(info.layout, info.loopPeriod));
  PELAGIC_CHECK(validate(info.sea, info.layout));
  if (!(info.warp >= 0 && info.warp <= 0.1)) return rejectField("WavesInfo::warp", info.warp, "lie in 0 … 0.1");
  PELAGIC_CHECK(validate(info.gain, info.layout.count));
  if (info.precision != MapPrecision::half && info.precision != MapPrecision::single) {
    return rejectField("WavesInfo::precision", static_cast<int>(info.precision), "be one of the enumerators");
  }
  if (info.framesInFlight < 1 || info.framesInFlight > 4) {
    return rejectField("WavesInfo::framesInFlight", info.framesInFlight, "lie in 1 … 4");
  }
  return {};
}

std::uint32_t foamCascades(const WaveLayout& layout) noexcept {
  std::uint32_t count = 1;
  const auto middle = [&](const Cascade& cascade) { return std::sqrt(cascade.kMin * cascade.kMax); };
  while (count < layout.count && middle(layout.cascades[count]) < kTwoPi / kShortestFoamingWave) ++count;
  return count;
}

GridSea makeGridSea(const SeaState& sea, const WavesInfo& info) {
  const WaveLayout& layout = info.layout;
  GridSea grid;
  grid.sea = sea;
  std::array<JacobianSpread, kMaxCascades> spreads{};
  glm::dvec3 slopes(0);
  ModeEnergies energies;
  const GridTrochoids trochoids = trochoidsOnGrid(sea, layout, info.warp);
  for (std::uint32_t c = 0; c < layout.count; ++c) {
    const CascadeModes modes = makeModes(sea, layout, c, info.loopPeriod, trochoids);
    const CascadeMoments moments = momentsOf(modes, layout.cascades[c], layout.size);
    grid.amplitudes.insert(grid.amplitudes.end(), modes.amplitude.begin(), modes.amplitude.end());
    grid.constants.insert(grid.constants.end(), modes.constants.begin(), modes.constants.end());
    grid.moments.slopes[c] = moments.slopes;
    grid.moments.interpolationLoss[c] = interpolationLoss(modes, layout.size);
    grid.moments.resolvedShare[c] = resolvedShare(modes, layout.size);
    grid.moments.elevation += moments.elevation;
    grid.moments.horizontal += moments.horizontal;
    grid.cascades[c].waveNumberStep = static_cast<float>(kTwoPi / layout.cascades[c].length);
    grid.cascades[c].heightScale = heightScale(moments);
    spreads[c] = jacobianSpread(modes, layout.cascades[c], layout.size, info.loopPeriod);
    grid.report.frequencyError = std::max(
        grid.report.frequencyError, frequencyError(modes, layout.cascades[c], layout.size, sea.depth, info.loopPeriod));
    slopes += moments.slopes;
    energies.add(modes, info.loopPeriod);
  }

  for (const GridTrochoid& trochoid : trochoids.waves) {
    grid.moments.trochoidHeight += trochoid.wave.amplitude;
    grid.moments.trochoidReach += trochoid.wave.steepness * trochoid.wave.amplitude;
  }

  SeaReport& report = grid.report;
  report.targetHeight = significantWaveHeight(sea);
  report.gridHeight = 4 * std::sqrt(grid.moments.elevation);
  report.peakPeriod = peakPeriod(sea);
  report.gridPeakPeriod = gridPeakPeriod(sea, energies);
  report.wavelengthsInPatch = layout.cascades[0].length / longestPeakWavelength(sea);
  report.target = coxMunkSlopes(sea.windSpeed);
  report.grid = alongWind(slopes, sea.windDirection);
  const SlopeVariance tail = slopeVariance(sea, layout.cascades[layout.count - 1].kMax, shortestWaveNumber(sea));
  report.unresolved = {std::max(report.target.upwind - report.grid.upwind, tail.upwind),
                       std::max(report.target.crosswind - report.grid.crosswind, tail.crosswind)};
  report.steepnessScale = trochoids.steepnessScale;
  report.whitecaps = whitecapFraction(sea.windSpeed);

  const std::span foaming = std::span(spreads).first(foamCascades(layout));
  const double threshold = foldThreshold(foaming, report.whitecaps);
  for (std::size_t c = 0; c < foaming.size(); ++c) {
    grid.cascades[c].foldThreshold = static_cast<float>(threshold);
    grid.cascades[c].inverseSpread = static_cast<float>(inverseSpread(foaming, c));
  }
  grid.foamDecline = foamDecline(foaming, threshold);
  return grid;
}

}  // namespace pelagic
