// Light in the water and at its surface.
#ifndef PELAGIC_PHYSICS_OPTICS_GLSL
#define PELAGIC_PHYSICS_OPTICS_GLSL
#include "physics/fresnel.glsl"

PELAGIC_PHYSICS_BEGIN

// Irradiance reflectance of deep water just below the surface from absorption and backscatter [1/m]: Gordon's
// R = 0.33 b_b / (a + b_b).
PELAGIC_FORMULA vec3 deepReflectance(vec3 absorption, vec3 backscatter) {
  return 0.33f * backscatter / (absorption + backscatter);
}

// Part of the sky's diffuse light that a flat sea reflects, for an even sky [1]; quadrature of the exact law at n = 1.34.
PELAGIC_FORMULA_CONSTANT float kDiffuseReflectance = 0.0675f;

// Radiance of the water just above the surface per downward irradiance that has entered it [1/sr]:
// 0.96 R / (n^2 Q (1 - 0.48 R)). 0.96: transmission upward; 0.48: the share of upward light that the surface sends back;
// Q = 4: ratio of upward irradiance to upward radiance, pi for an even field.
PELAGIC_FORMULA vec3 waterLeaving(vec3 reflectance) {
  return 0.96f * reflectance / (kWaterIndex * kWaterIndex * 4.0f * (1.0f - 0.48f * reflectance));
}

// The same of what bubbles below foam add to it: those that a wave has just carried down (freshness 1) send a quarter back, from
// 1.5 m deep in the mean, and fewer as they rise and the foam ages. Water takes its share on the way down and up, which leaves
// plumes blue-green in a clear sea (Stramski & Tegowski 2001). Strength and depth are chosen, within what plumes show.
PELAGIC_FORMULA vec3 plumeLeaving(vec3 absorption, float freshness) {
  return waterLeaving(0.25f * freshness * exp(-2.0f * 1.5f * absorption));
}

// How opaque water of a thickness [m] looks that is opaque from `opaqueDepth` [m] on: O_min + (1 - O_min) sqrt(min(t / D, 1)).
PELAGIC_FORMULA float tintOpacity(float thickness, float leastOpacity, float opaqueDepth) {
  return leastOpacity + (1.0f - leastOpacity) * sqrt(min(thickness / opaqueDepth, 1.0f));
}

// Irradiance that enters the water [as the inputs] from a sun at the height sunY = sin(elevation) and from the sky.
PELAGIC_FORMULA vec3 enteringIrradiance(vec3 sun, float sunY, vec3 sky) {
  float y = max(sunY, 0.0f);
  return sun * (y * (1.0f - fresnelReflectance(y, kWaterIndex))) + sky * (1.0f - kDiffuseReflectance);
}

PELAGIC_PHYSICS_END
#endif
