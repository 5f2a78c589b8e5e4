// Short waves on long ones. Compiles as GLSL and, through GLM, as C++.
#ifndef PELAGIC_PHYSICS_MODULATION_GLSL
#define PELAGIC_PHYSICS_MODULATION_GLSL
#include "physics/formula.h"

PELAGIC_PHYSICS_BEGIN

// Slope variance of the short waves where longer ones push the water together by a = -div D, per their mean [1]: ripples are
// steep on crests and lie calm in troughs. A long wave of slope K A makes those that it carries shorter by 1 + K A cos, and
// since their action is kept as much higher (Longuet-Higgins & Stewart 1960), which is 4 a. The wind restores them on the
// way: three quarters of it are left here, since with all of it the far sea under a low sun would be 3 % brighter where pixels
// resolve the longer waves than where they do not. The part in a^2 keeps the mean over the sea's surface, of which a crest
// takes up less by 1 - a.
PELAGIC_FORMULA_CONSTANT float kShortWaveModulation = 3.0f;

// Where the water folds over there is no such theory: `a` is held to where shading holds the Jacobian. The calmest is -1/2.
PELAGIC_FORMULA_CONSTANT float kMostPushedTogether = 0.85f;

PELAGIC_FORMULA float shortWaveVariance(float a) {
  float held = clamp(a, -0.5f, kMostPushedTogether);
  return 1.0f + kShortWaveModulation * held * (1.0f + held);
}

PELAGIC_PHYSICS_END
#endif
