/// A sea that gives way to another one over a stretch of time.
#pragma once

#include <waves/grid_sea.hpp>

namespace pelagic {

/// Checks every field; the error names it, its value and its range.
Result<void> validate(const SeaTransition& transition);

/// Share that the new sea has in the amplitudes, and how it grows.
struct Share {
  double value = 1;         ///< 0 … 1
  double rate = 0;          ///< [1/s]
  double acceleration = 0;  ///< [1/s^2]
};
Share shareAt(const SeaTransition& transition, double time) noexcept;

struct SeaChange {
  GridSea after;
  GridSea before;  ///< Without modes when there is no change.
  SeaTransition transition;
  /// Moments of the difference of both seas' modes: what the mixture is calmer by than the mean of both.
  SeaMoments difference;

  bool changing() const noexcept { return !before.amplitudes.empty(); }
  Share share(double time) const noexcept { return changing() ? shareAt(transition, time) : Share{}; }
  SeaMoments momentsAt(double share) const noexcept;
  SlopeVariance unresolvedAt(double share) const noexcept;
  /// Of the stronger part: patterns that are drawn along the wind would sweep over the sea if it turned.
  double windDirectionAt(double share) const noexcept;
  double windSpeedAt(double share) const noexcept;
  double choppinessAt(double share) const noexcept;
  double foamDeclineAt(double share) const noexcept;
};

/// From the sea as `now` has it at the start of the transition to `next`; at once, at all times, when that takes no
/// time.
SeaChange changeSea(const SeaChange& now, GridSea next, const SeaTransition& transition, const WavesInfo& info);

}  // namespace pelagic
