// Short waves on long ones. Compiles as GLSL and, through GLM, as C++.
#ifndef PELAGIC_PHYSICS_MODULATION_GLSL
#define PELAGIC_PHYSICS_MODULATION_GLSL
#include "physics/formula.h"

PELAGIC_PHYSICS_BEGIN

// Steepness of the short waves where longer ones push the water together by a = -div D, per their mean [1]: ripples are steep
// on crests and lie calm in troughs. A long wave of slope K A makes those that it carries shorter by 1 + K A cos, and since
// their action is kept as much higher (Longuet-Higgins & Stewart 1960). In the mean over the sea's surface, of which a crest
// takes up less by 1 - a, the square of 1 + 2a is 1, and their slope variance what it was.
PELAGIC_FORMULA float shortWaveSteepness(float a) { return max(1.0f + 2.0f * a, 0.0f); }

PELAGIC_PHYSICS_END
#endif
