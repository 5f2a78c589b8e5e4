/// The warp between the sea and the patches, anywhere in the world.
#pragma once

#include <pelagic/shader/wave_sampling.h>

#include <pelagic/waves.hpp>
#include <waves/float4.hpp>

namespace pelagic {

/// The warp close to a place, where it is as good as linear: within 1e-4 Hs of the height that it gives.
struct LocalWarp {
  glm::vec2 shift{0};   ///< At the place [m].
  glm::mat2 slopes{0};  ///< Columns: along x, along z [1].
  /// `offset` [m] from the place.
  glm::vec2 shiftAt(const glm::vec2& offset) const noexcept { return shift + slopes * offset; }
};

/// The largest stretch that the warp's gradient does, in standard deviations of its components: none of 3e6 places had
/// more than 4.13.
inline constexpr double kLargestStretch = 4.5;

/// `gradient`: as WavesInfo::warp.
class Warp {
 public:
  Warp(const WaveLayout& layout, double gradient) noexcept;
  /// For shaders whose points are relative to `origin` [m].
  shader::WaveWarp relativeTo(const glm::dvec2& origin) const noexcept;
  /// As waveWarp() and waveWarpSlopes() in shader/wave_lookup.glsl.
  LocalWarp at(const glm::dvec2& place) const noexcept;

 private:
  static constexpr std::size_t kWaves = 8;
  struct Turns {
    alignas(16) float of[kWaves];
  };
  /// Less the nearest whole number.
  Turns turnsAt(const glm::dvec2& place) const noexcept;

  /// Turns per metre.
  std::array<double, kWaves> alongX_{};
  std::array<double, kWaves> alongZ_{};
  shader::WaveWarp still_{};  ///< Without phases.
};

}  // namespace pelagic
