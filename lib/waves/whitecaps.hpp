/// Where the sea has to break for the whitecaps of its wind.
#pragma once

#include <span>
#include <waves/modes.hpp>

namespace pelagic {

/// The Jacobian of one cascade at a point: 1 + s + curvature (s^2 - deviation^2) in the mean, where s = dDx/dx + dDz/dz
/// is a Gaussian process in time.
struct JacobianSpread {
  double deviation = 0;  ///< Standard deviation of s [1].
  double rate = 0;       ///< Standard deviation of ds/dt [1/s].
  double curvature = 0;  ///< (E[dDx/dx dDz/dz - dDz/dx^2 | s] - its mean) / (s^2 - deviation^2) [1].
};
JacobianSpread jacobianSpread(const CascadeModes& modes, const Cascade& cascade, std::uint32_t size, double loopPeriod);

/// 1 / standard deviation of all bands but `cascade`, for shader::breakingCoverage. A band without company is given a
/// quarter of its own spread, which softens its edges. 1 when nothing moves.
double inverseSpread(std::span<const JacobianSpread> bands, std::size_t cascade) noexcept;

/// Expected mean of the foam that the maps show, breaking and fading, summed over the bands.
double expectedFoam(std::span<const JacobianSpread> bands, double threshold) noexcept;

/// w of a sea whose foam falls as exp(-w (1/g^2 - 1)) where all its waves are multiplied by g, from g = 0.8, between
/// the gusts and lulls of a real wind; 0 … 100. At most kMaxCascades bands.
double foamDecline(std::span<const JacobianSpread> bands, double threshold) noexcept;

/// The Jacobian below which the sea breaks so that expectedFoam is `coverage`; out of reach when nothing moves.
double foldThreshold(std::span<const JacobianSpread> bands, double coverage) noexcept;

}  // namespace pelagic
