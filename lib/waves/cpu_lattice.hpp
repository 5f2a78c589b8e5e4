/// One cascade of the sea at one time, on the CPU.
#pragma once

#include <waves/fft.hpp>
#include <waves/sea_change.hpp>

namespace pelagic {

/// What the lattice holds at its points, in texels of four: as the wave maps, and how it moves.
struct LatticeTexels {
  std::vector<glm::vec4> displacement;  ///< Dx, h, Dz [m]; dDz/dx [1].
  std::vector<glm::vec4> gradient;      ///< dh/dx, dh/dz, dDx/dx, dDz/dz [1].
  std::vector<glm::vec4> velocity;      ///< d/dt of (Dx, h, Dz) [m/s].
  std::vector<glm::vec4> acceleration;  ///< [m/s^2].
};

/// Linear between four texels.
struct LatticePlace {
  std::size_t corners[4];  ///< (x, z), (x+1, z), (x, z+1), (x+1, z+1)
  float x, z;              ///< Shares of the far ones.
  glm::vec4 value(const std::vector<glm::vec4>& texels) const noexcept {
    return glm::mix(glm::mix(texels[corners[0]], texels[corners[1]], x),
                    glm::mix(texels[corners[2]], texels[corners[3]], x), z);
  }
};

/// std::floor() is a call where the processor is not known to round.
inline std::int64_t floorOf(double x) noexcept {
  const auto whole = static_cast<std::int64_t>(x);
  return whole - (x < static_cast<double>(whole));
}

class CpuLattice {
 public:
  /// Modes with |k| > kMax are left out.
  CpuLattice(const SeaChange& sea, const WavesInfo& info, std::uint32_t cascade, double kMax);
  /// Transforms to `time` [s], with the later sea's `share`; `plane` and `scratch` are N x N, their contents unused.
  void evolve(double time, const Share& share, const InverseFft& fft, ComplexPlane& plane,
              ComplexPlane& scratch) noexcept;

  const LatticeTexels& texels() const noexcept { return texels_; }
  LatticePlace placeOf(const glm::dvec2& point) const noexcept;
  /// Fetches what is displaced at a place, which is to be asked for soon.
  void prefetch(const LatticePlace& place) const noexcept {
#ifdef __GNUC__
    for (const std::size_t corner : place.corners) __builtin_prefetch(&texels_.displacement[corner]);
#else
    static_cast<void>(place);
#endif
  }
  /// Texels per metre.
  double density() const noexcept { return density_; }

 private:
  /// A mode of one sea.
  struct Wave {
    std::uint32_t cycles = 0;
    glm::vec2 chop{0};    ///< As ModeConstants.
    float frequency = 0;  ///< Quantised [rad/s].
    glm::vec4 amplitude{0};
  };
  /// Spectrum h(k) of the elevation or of one of its derivatives in time, and chop times it.
  struct Spectral {
    glm::vec2 h{0};
    glm::vec2 chop{0};
  };
  /// A mode that exists, and what it is at the time.
  struct Mode {
    std::uint32_t index = 0;
    float kx = 0, kz = 0;  ///< [rad/m]
    Wave after, before;
    Spectral elevation;     ///< [m]
    Spectral rate;          ///< d/dt [m/s]
    Spectral acceleration;  ///< d2/dt2 [m/s^2]
  };
  enum class Operator { height, dx, dz, hx, hz, dxdx, dzdz, dzdx };
  static glm::vec2 apply(Operator wanted, const Mode& mode, const Spectral& of) noexcept;
  /// Adds one sea's part of a mode with a weight that itself changes.
  static void add(const Wave& wave, std::uint64_t fraction, const Share& share, Mode& mode) noexcept;

  std::uint32_t size_;
  double density_;
  double loopPeriod_;
  bool changing_;
  std::vector<Mode> modes_;
  LatticeTexels texels_;
};

inline LatticePlace CpuLattice::placeOf(const glm::dvec2& point) const noexcept {
  const glm::dvec2 at = point * density_;
  const std::int64_t baseX = floorOf(at.x);
  const std::int64_t baseZ = floorOf(at.y);
  const std::size_t x = static_cast<std::size_t>(baseX) & (size_ - 1);
  const std::size_t z = static_cast<std::size_t>(baseZ) & (size_ - 1);
  const std::size_t nextX = (x + 1) & (size_ - 1);
  const std::size_t row = z * size_;
  const std::size_t nextRow = ((z + 1) & (size_ - 1)) * size_;
  return {{row + x, row + nextX, nextRow + x, nextRow + nextX},
          static_cast<float>(at.x - static_cast<double>(baseX)),
          static_cast<float>(at.y - static_cast<double>(baseZ))};
}

}  // namespace pelagic
