// Lets a file of formulas compile as GLSL and, through GLM, as C++. Literals carry an f, vectors are swizzled by
// member.
#ifndef PELAGIC_PHYSICS_FORMULA_H
#define PELAGIC_PHYSICS_FORMULA_H
#ifdef __cplusplus
#include "pelagic/shader/types.h"
namespace pelagic::physics {
using namespace glm;  // NOLINT: GLSL's names without a prefix
}
#define PELAGIC_PHYSICS_BEGIN namespace pelagic::physics {
#define PELAGIC_PHYSICS_END }
#define PELAGIC_FORMULA inline
#define PELAGIC_FORMULA_CONSTANT inline constexpr
#else
#define PELAGIC_PHYSICS_BEGIN
#define PELAGIC_PHYSICS_END
#define PELAGIC_FORMULA
#define PELAGIC_FORMULA_CONSTANT const
#endif
#endif
