/// What the tests of the wave stage share: small seas, and the fields that a double-precision sum gives for them.
#pragma once

#include <array>
#include <pelagic/waves.hpp>
#include <vector>
#include <waves/modes.hpp>

#include "support/gpu_test.hpp"

namespace support {

/// h, Dx, Dz, dh/dx, dh/dz, dDx/dx, dDz/dz, dDz/dx.
inline constexpr std::size_t kFields = 8;
inline constexpr std::array<const char*, kFields> kFieldNames{"h",     "Dx",     "Dz",     "dh/dx",
                                                              "dh/dz", "dDx/dx", "dDz/dz", "dDz/dx"};
using Fields = std::array<std::vector<double>, kFields>;  ///< N x N each, row = z.

class WavesTest : public GpuTest {
 protected:
  /// Creates or fails the test.
  pelagic::Waves create(const pelagic::WavesInfo& info);
  void record(pelagic::Waves& waves, double time);
  /// The maps' finest mip as fields.
  Fields read(const pelagic::WaveMaps& maps, std::uint32_t cascade);
};

/// Calm, breeze, gale, storm with swell, and swell in shallow water.
std::vector<pelagic::SeaState> fiveSeas();
pelagic::WavesInfo wavesInfo(std::uint32_t size, std::uint32_t count, double windSpeed = 8);

/// The eight spectra of a cascade at `time`, transformed by FFTW in double precision, one field at a time. Phases come
/// from n t / T in extended precision, not from the library's integers.
Fields referenceFields(const pelagic::WavesInfo& info, std::uint32_t cascade, double time);

/// |a - b| / |b| over all samples.
double relativeError(const std::vector<double>& a, const std::vector<double>& b);
double meanOf(const std::vector<double>& values);
double varianceOf(const std::vector<double>& values);

}  // namespace support
