/// The spectrum on the grid: what the GPU evolves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <pelagic/waves.hpp>
#include <vector>
#include <waves/trochoids.hpp>

namespace pelagic {

/// Product of complex numbers.
inline glm::vec2 times(const glm::vec2& a, const glm::vec2& b) noexcept {
  return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

/// Signed mode number of index i in FFT order.
int modeOf(std::uint32_t i, std::uint32_t size) noexcept;

/// What the evolve pass knows of a mode besides its amplitude: a texel of four words.
struct alignas(16) ModeConstants {
  std::uint32_t cycles = 0;  ///< n: the mode turns n times per loop period; 0 where the mode does not exist.
  /// choppiness coth(k h) / k e^{-i lean} [m], a complex number; D = i k chop h. The lean turns its sign with k.
  glm::vec2 chop{0};
};
static_assert(sizeof(ModeConstants) == 16 && offsetof(ModeConstants, chop) == 4, "as the shaders fetch it");

/// All modes of one cascade, N x N in FFT order, row = z.
struct CascadeModes {
  /// (Re h0(k), Im h0(k), Re conj h0(-k), Im conj h0(-k)) [m].
  std::vector<glm::vec4> amplitude;
  std::vector<ModeConstants> constants;
  /// Expected E|h(k)|^2 = [Psi(k) + Psi(-k)]/2 dk^2 [m^2].
  std::vector<double> variance;
};

/// Deterministic in (seed, cascade, mode) on every machine. DC, the Nyquist row and column, and modes outside
/// [kMin, kMax) or beyond shortestWaveNumber() are zero. `trochoids`: the sea's, on this layout.
CascadeModes makeModes(const SeaState& sea, const WaveLayout& layout, std::uint32_t cascade, double loopPeriod,
                       const GridTrochoids& trochoids);
CascadeModes makeModes(const SeaState& sea, const WaveLayout& layout, std::uint32_t cascade, double loopPeriod);

/// Phase of n cycles per loop at time t: 2 pi frac(n t / T) with the 64-bit fraction of t/T, exact for any t.
std::uint64_t loopFraction(double time, double loopPeriod) noexcept;

/// Expected elevation variance [m^2], variance of the horizontal displacement's length [m^2] and slope covariance
/// (xx, zz, xz) of a cascade's modes.
struct CascadeMoments {
  double elevation = 0;
  double horizontal = 0;
  glm::dvec3 slopes{0};
};
CascadeMoments momentsOf(const CascadeModes& modes, const Cascade& cascade, std::uint32_t size);

}  // namespace pelagic
