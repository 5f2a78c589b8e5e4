// Where the sea breaks. Compiles as GLSL and, through GLM, as C++.
#ifndef PELAGIC_PHYSICS_WHITECAPS_GLSL
#define PELAGIC_PHYSICS_WHITECAPS_GLSL

#ifdef __cplusplus
#include <pelagic/shader/types.h>
namespace pelagic::shader {
#define PELAGIC_PHYSICS_FUNCTION inline
using glm::clamp;
using glm::smoothstep;
using glm::tanh;
#else
#define PELAGIC_PHYSICS_FUNCTION
#endif

// Normal distribution function, to 2e-4.
PELAGIC_PHYSICS_FUNCTION float normalDistribution(float x) {
  return 0.5f + 0.5f * tanh(clamp(x, -6.0f, 6.0f) * (0.7978845608f + 0.0356774081f * x * x));
}

// Share of the water that breaks where one band's Jacobian is `jacobian`, from the probability that the other bands, of
// standard deviation 1 / inverseSpread, bring the sum below `threshold`: none where it is unlikely, all where it is more
// likely than not, so that whitecaps have edges and no faint film covers the sea.
PELAGIC_PHYSICS_FUNCTION float breakingCoverage(float jacobian, float threshold, float inverseSpread) {
  return smoothstep(0.4f, 0.6f, normalDistribution((threshold - jacobian) * inverseSpread));
}

#ifdef __cplusplus
}  // namespace pelagic::shader
#endif
#undef PELAGIC_PHYSICS_FUNCTION

#endif
