/// Single trochoids among the modes of the grid.
#pragma once

#include <pelagic/waves.hpp>
#include <vector>

namespace pelagic {

/// Checks that the patches of a layout can hold every trochoid of a valid sea.
Result<void> validate(const SeaState& sea, const WaveLayout& layout);

struct GridTrochoid {
  std::uint32_t cascade = 0;
  int mx = 0, mz = 0;  ///< Its mode.
  Trochoid wave;       ///< As it is on the grid.
};

struct GridTrochoids {
  std::vector<GridTrochoid> waves;
  double steepnessScale = 1;  ///< What every steepness was multiplied by, so that the crests do not loop [1].
  /// Random waves longer than 2 pi/cut [rad/m] keep the share `kept` of their energy.
  double cut = 0;
  double kept = 1;
};
/// Of a sea that validate() has found good: those given one by one, then those picked from its spectrum. `warp`: as
/// WavesInfo::warp, which makes waves shorter here and there.
GridTrochoids trochoidsOnGrid(const SeaState& sea, const WaveLayout& layout, double warp);

}  // namespace pelagic
