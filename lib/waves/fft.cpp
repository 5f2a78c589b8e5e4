#include <cmath>
#include <numbers>
#include <waves/fft.hpp>

namespace pelagic {

InverseFft::InverseFft(std::uint32_t size) : size_(size), reversed_(size), cosines_(size / 2), sines_(size / 2) {
  for (std::uint32_t i = 1; i < size; ++i) reversed_[i] = reversed_[i / 2] / 2 + (i % 2) * size / 2;
  for (std::uint32_t i = 0; i < size / 2; ++i) {
    const double angle = 2 * std::numbers::pi * i / size;
    cosines_[i] = static_cast<float>(std::cos(angle));
    sines_[i] = static_cast<float>(std::sin(angle));
  }
}

void InverseFft::transposeReversed(const ComplexPlane& from, ComplexPlane& to) const noexcept {
  constexpr std::uint32_t kBlock = 16;  // lines of both planes that stay in the cache
  for (std::uint32_t rows = 0; rows < size_; rows += kBlock) {
    for (std::uint32_t column = 0; column < size_; ++column) {
      const std::size_t target = std::size_t{reversed_[column]} * size_;
      for (std::uint32_t row = rows; row < rows + kBlock; ++row) {
        to.re[target + row] = from.re[std::size_t{row} * size_ + column];
        to.im[target + row] = from.im[std::size_t{row} * size_ + column];
      }
    }
  }
}

/// Cooley & Tukey (1965), radix 2, of all columns at a time; rows come in bit-reversed order.
void InverseFft::transformColumns(ComplexPlane& plane) const noexcept {
  for (std::uint32_t half = 1; half < size_; half *= 2) {
    for (std::uint32_t first = 0; first < size_; first += 2 * half) {
      for (std::uint32_t i = 0; i < half; ++i) {
        const float c = cosines_[i * (size_ / 2 / half)];
        const float s = sines_[i * (size_ / 2 / half)];
        float* aRe = plane.re.data() + std::size_t{first + i} * size_;
        float* aIm = plane.im.data() + std::size_t{first + i} * size_;
        float* bRe = aRe + std::size_t{half} * size_;
        float* bIm = aIm + std::size_t{half} * size_;
        for (std::uint32_t column = 0; column < size_; ++column) {
          const float re = c * bRe[column] - s * bIm[column];
          const float im = c * bIm[column] + s * bRe[column];
          bRe[column] = aRe[column] - re;
          bIm[column] = aIm[column] - im;
          aRe[column] += re;
          aIm[column] += im;
        }
      }
    }
  }
}

void InverseFft::transform(ComplexPlane& plane, ComplexPlane& scratch) const noexcept {
  transposeReversed(plane, scratch);
  transformColumns(scratch);
  transposeReversed(scratch, plane);
  transformColumns(plane);
}

}  // namespace pelagic
