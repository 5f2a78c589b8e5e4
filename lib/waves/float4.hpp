/// Four floats that the compiler keeps in one register, where it can: it does not find them in a glm::vec4.
#pragma once

#include <bit>
#include <glm/glm.hpp>

namespace pelagic {

#ifdef __GNUC__
using Float4 = float __attribute__((vector_size(16)));
inline Float4 absolute(Float4 v) noexcept {
  using Bits = int __attribute__((vector_size(16)));
  return std::bit_cast<Float4>(std::bit_cast<Bits>(v) & 0x7fffffff);
}
#else
using Float4 = glm::vec4;
inline Float4 absolute(const Float4& v) noexcept { return glm::abs(v); }
#endif

inline Float4 float4Of(const glm::vec4& v) noexcept { return std::bit_cast<Float4>(v); }
inline float sumOf(const Float4& v) noexcept { return (v[0] + v[1]) + (v[2] + v[3]); }

}  // namespace pelagic
