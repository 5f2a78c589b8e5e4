/// One cascade of the sea at one time, on the CPU.
#pragma once

#include <waves/fft.hpp>
#include <waves/modes.hpp>

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

class CpuLattice {
 public:
  /// Modes with |k| > kMax are left out.
  CpuLattice(const SeaState& sea, const WavesInfo& info, std::uint32_t cascade, double kMax);
  /// Transforms to `time` [s]; `plane` and `scratch` are N x N, their contents unused.
  void evolve(double time, const InverseFft& fft, ComplexPlane& plane, ComplexPlane& scratch) noexcept;

  const LatticeTexels& texels() const noexcept { return texels_; }
  LatticePlace placeOf(const glm::dvec2& point) const noexcept;
  /// Texels per metre.
  double density() const noexcept { return density_; }

 private:
  /// A mode that exists, and what it is at the time.
  struct Mode {
    std::uint32_t index = 0, cycles = 0;
    float kx = 0, kz = 0;  ///< [rad/m]
    float chop = 0;        ///< As ModeConstants.
    float frequency = 0;   ///< Quantised [rad/s].
    glm::vec4 amplitude{0};
    glm::vec2 elevation{0};     ///< h(k, t) [m].
    glm::vec2 rate{0};          ///< dh/dt [m/s].
    glm::vec2 acceleration{0};  ///< d2h/dt2 [m/s^2].
  };
  enum class Operator { height, dx, dz, hx, hz, dxdx, dzdz, dzdx };
  static glm::vec2 apply(Operator wanted, const Mode& mode, const glm::vec2& h) noexcept;

  std::uint32_t size_;
  double density_;
  double loopPeriod_;
  std::vector<Mode> modes_;
  LatticeTexels texels_;
};

}  // namespace pelagic
