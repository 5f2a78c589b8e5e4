// Lets one header define a struct for C++ and GLSL. Only 4-byte scalars, vec2 at 8-byte and vec4 at 16-byte offsets are
// used, so that std140 = std430 = C++.
#ifndef PELAGIC_SHADER_TYPES_H
#define PELAGIC_SHADER_TYPES_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
namespace pelagic::shader {
using glm::mat4;
using glm::vec2;
using glm::vec4;
using uint = std::uint32_t;
// A host's GLM_FORCE_ALIGNED_GENTYPES would change these silently.
static_assert(sizeof(vec2) == 8 && sizeof(vec4) == 16 && sizeof(mat4) == 64 && alignof(vec4) == 4);
}  // namespace pelagic::shader
#define PELAGIC_SHADER_BEGIN namespace pelagic::shader {
#define PELAGIC_SHADER_END }
#define PELAGIC_SHADER_CONSTANT inline constexpr
#else
#define PELAGIC_SHADER_BEGIN
#define PELAGIC_SHADER_END
#define PELAGIC_SHADER_CONSTANT const
#endif

#endif
