/// The warp between the sea and the patches, anywhere in the world.
#pragma once

#include <pelagic/shader/wave_sampling.h>

#include <pelagic/waves.hpp>
#include <waves/float4.hpp>

namespace pelagic {

/// The warp close to a place, where it is as good as linear: at the defaults within 1e-4 Hs of the height that it
/// gives.
struct LocalWarp {
  glm::vec2 shift{0};   ///< At the place [m].
  glm::mat2 slopes{0};  ///< Columns: along x, along z [1].
  /// `offset` [m] from the place.
  glm::vec2 shiftAt(const glm::vec2& offset) const noexcept { return shift + slopes * offset; }
};

/// The largest stretch that the warp's gradient can do, in standard deviations of its components: all eight waves at
/// their steepest, 8 sqrt(3/128) max over directions u and v of the sum of |d_i u| |q_i v|.
inline constexpr double kLargestStretch = 4.6;

/// `gradient`: as WavesInfo::warp. It leaves the origin of the world where it is, and the waves about it as they are.
class Warp {
 public:
  Warp(const WaveLayout& layout, double gradient) noexcept;
  /// For shaders whose points are relative to `origin` [m]; they look up from patchPlace(origin) on.
  shader::WaveWarp relativeTo(const glm::dvec2& origin) const noexcept;
  glm::dvec2 patchPlace(const glm::dvec2& place) const noexcept { return place - origin_; }
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
  glm::dvec2 origin_{0};      ///< What the waves shift the origin by [m].
};

}  // namespace pelagic
