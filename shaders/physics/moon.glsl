// Light of the moon and the stars. Compiles as GLSL and, through GLM, as C++.
#ifndef PELAGIC_PHYSICS_MOON_GLSL
#define PELAGIC_PHYSICS_MOON_GLSL
#include "physics/formula.h"

PELAGIC_PHYSICS_BEGIN

// Irradiance of the full moon per the sun's, over the air: magnitude -12.73, 0.314 lx of 1.334e5 lx (Allen 1973).
PELAGIC_FORMULA_CONSTANT float kFullMoon = 2.35e-6f;
// The moon is redder than the sun: its albedo over the channels, 1 in luminance (Kieffer & Stone 2005).
PELAGIC_FORMULA_CONSTANT vec3 kMoonTint = vec3(1.12f, 0.985f, 0.80f);

// Irradiance of the moon per the sun's when the part `illuminated` of its disc is lit: Allen's (1973) magnitudes
// 0.026 |phi| + 4e-9 phi^4 below the full moon's, phi the phase angle in degrees, illuminated = (1 + cos phi)/2.
PELAGIC_FORMULA float moonStrength(float illuminated) {
  float phase = acos(clamp(2.0f * illuminated - 1.0f, -1.0f, 1.0f)) * 57.29578f;
  float magnitude = 0.026f * phase + 4e-9f * phase * phase * phase * phase;
  return kFullMoon * exp2(-1.3287712f * magnitude);
}

// Irradiance of a star of magnitude m per the sun's: 2.54e-6 lx at m = 0.
PELAGIC_FORMULA float starStrength(float magnitude) { return 1.904e-11f * exp2(-1.3287712f * magnitude); }

// Magnitude of a star drawn from `count` all over the sky, u = 0 ... 1: as many are brighter than m as there are real ones,
// 9100 to m = 6.5 and 10^0.5 times as many to the next magnitude.
PELAGIC_FORMULA float starMagnitude(float u, float count) { return 6.5f + 0.60206f * log2(max(u * count, 1.0f) / 9100.0f); }

PELAGIC_PHYSICS_END
#endif
