/// One cascade of a sea on the CPU, as the tests look at it.
#pragma once

#include <cmath>
#include <waves/cpu_lattice.hpp>

namespace unit {

inline pelagic::CpuLattice latticeOf(const pelagic::WavesInfo& info, std::uint32_t cascade, double time,
                                     double kMax = HUGE_VAL) {
  pelagic::SeaChange sea;
  sea.after = makeGridSea(info.sea, info);
  pelagic::CpuLattice lattice(sea, info, cascade, kMax);
  const pelagic::InverseFft fft(info.layout.size);
  const std::size_t count = std::size_t{info.layout.size} * info.layout.size;
  pelagic::ComplexPlane plane{std::vector<float>(count), std::vector<float>(count)};
  pelagic::ComplexPlane scratch = plane;
  lattice.evolve(time, {}, fft, plane, scratch);
  return lattice;
}

}  // namespace unit
