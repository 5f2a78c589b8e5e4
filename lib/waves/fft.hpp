/// The CPU's inverse Fourier transform.
#pragma once

#include <cstdint>
#include <vector>

namespace pelagic {

/// Square planes of complex numbers, row = z, real and imaginary parts apart so that neighbouring columns are
/// transformed together.
struct ComplexPlane {
  std::vector<float> re, im;
};

/// f(x, z) = sum over k of F(k) e^{+i k.x} of N x N planes, N a power of two; no factor.
class InverseFft {
 public:
  explicit InverseFft(std::uint32_t size);
  /// In place. `scratch` is a plane of the same size.
  void transform(ComplexPlane& plane, ComplexPlane& scratch) const noexcept;

 private:
  void transformColumns(ComplexPlane& plane) const noexcept;
  /// Rows of `from` become columns of `to`, in bit-reversed order of rows.
  void transposeReversed(const ComplexPlane& from, ComplexPlane& to) const noexcept;

  std::uint32_t size_;
  std::vector<std::uint32_t> reversed_;
  std::vector<float> cosines_, sines_;  ///< Of 2 pi i / N, i < N/2.
};

}  // namespace pelagic
