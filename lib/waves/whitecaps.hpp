/// Where the sea has to break for the whitecaps of its wind.
#pragma once

#include <span>
#include <waves/modes.hpp>

namespace pelagic {

/// The Jacobian of one cascade, linearised to 1 + dDx/dx + dDz/dz: a Gaussian process in time at every point.
struct JacobianSpread {
  double deviation = 0;  ///< Standard deviation [1].
  double rate = 0;       ///< Standard deviation of its time derivative [1/s].
};
JacobianSpread jacobianSpread(const CascadeModes& modes, const Cascade& cascade, std::uint32_t size, double loopPeriod);

/// 1 / standard deviation of all bands but `cascade`, for shader::breakingCoverage. A band without company is given a
/// quarter of its own spread, which softens its edges. 0 when there is no motion at all.
double inverseSpread(std::span<const JacobianSpread> bands, std::size_t cascade) noexcept;

/// Expected mean of the foam that the maps show, breaking and fading, summed over the bands.
double expectedFoam(std::span<const JacobianSpread> bands, double threshold) noexcept;

/// The Jacobian below which the sea breaks so that expectedFoam is `coverage`.
double foldThreshold(std::span<const JacobianSpread> bands, double coverage) noexcept;

}  // namespace pelagic
