/// A sea state made ready for the GPU, with the numbers that describe it.
#pragma once

#include <shared/waves.h>

#include <waves/modes.hpp>

namespace pelagic {

/// Expected of all modes together: elevation [m^2], length of the horizontal displacement [m^2], and for each cascade
/// the slope covariance (xx, zz, xz) [1].
struct SeaMoments {
  double elevation = 0;
  double horizontal = 0;
  /// Of the trochoids: sum of A and of Q A [m], which add up where they meet, as random waves do not.
  double trochoidHeight = 0;
  double trochoidReach = 0;
  std::array<glm::dvec3, kMaxCascades> slopes{};
  std::array<InterpolationLoss, kMaxCascades> interpolationLoss{};  ///< As in WaveMaps, and
  std::array<ResolvedShare, kMaxCascades> resolvedShare{};          ///< this.
};

/// Standard deviation of the elevation, and of the length of the horizontal displacement [m], or as much more as puts
/// the highest that trochoids can reach together at 6 of them.
double elevationDeviation(const SeaMoments& moments) noexcept;
double horizontalDeviation(const SeaMoments& moments) noexcept;

struct GridSea {
  SeaState sea;
  /// Of all cascades, one after the other; see CascadeModes.
  std::vector<glm::vec4> amplitudes;
  std::vector<ModeConstants> constants;
  std::array<shader::WaveCascade, kMaxCascades> cascades{};
  SeaMoments moments;
  double foamDecline = 0;  ///< As in WaveMaps.
  SeaReport report;
};

/// Checks every field; the error names it, its value and its range.
Result<void> validate(const WavesInfo& info);

/// How many cascades, from the longest, keep foam: those whose waves are longer than four metres, at the
/// middle of the band; at least one.
std::uint32_t foamCascades(const WaveLayout& layout) noexcept;

/// `sea` and `info` must be valid; `info.sea` is not used.
GridSea makeGridSea(const SeaState& sea, const WavesInfo& info);

}  // namespace pelagic
