// Fresnel reflectance of unpolarised light.
#ifndef PELAGIC_PHYSICS_FRESNEL_GLSL
#define PELAGIC_PHYSICS_FRESNEL_GLSL
#include "physics/formula.h"

PELAGIC_PHYSICS_BEGIN

// Refractive index of sea water, relative to air [1].
PELAGIC_FORMULA_CONSTANT float kWaterIndex = 1.34f;

// Exact reflectance for the cosine of the angle of incidence, 0 ... 1, and the index of the far side relative to the
// near side: 1.34 from the air; 1/1.34 from the water, where it is 1 outside Snell's window.
PELAGIC_FORMULA float fresnelReflectance(float cosIncidence, float index) {
  float c = cosIncidence;
  float squared = index * index - 1.0f + c * c;
  if (squared <= 0.0f) return 1.0f;
  float g = sqrt(squared);  // index times the cosine of the refracted ray
  float s = (c - g) / (c + g);
  float p = (c * (g + c) - 1.0f) / (c * (g - c) + 1.0f);
  return 0.5f * s * s * (1.0f + p * p);
}

// Mean reflectance of a rough sea, the fit of Bruneton et al. (2010) with Schlick's law: the reference path, off by up to
// 0.16. Shading uses a table integrated from fresnelReflectance().
PELAGIC_FORMULA float meanFresnelFit(float cosView, float deviation) {
  float r = 0.02f;
  float schlick = pow(1.0f - cosView, 5.0f * exp(-2.69f * deviation));
  return r + (1.0f - r) * schlick / (1.0f + 22.7f * deviation * sqrt(deviation));
}

// The table of mean reflectance and of how the facets that reflect face the view: entry (i,j) is for cosView =
// (i/(width-1))^2 and a standard deviation of the slope along the view of kFresnelMaxDeviation (j/(height-1))^2,
// which is dense where the reflectance changes fast.
PELAGIC_FORMULA_CONSTANT int kFresnelTableWidth = 32;
PELAGIC_FORMULA_CONSTANT int kFresnelTableHeight = 16;
PELAGIC_FORMULA_CONSTANT float kFresnelMaxDeviation = 0.6f;

// Place in the table [entries].
PELAGIC_FORMULA vec2 fresnelTablePlace(float cosView, float deviation) {
  return vec2(sqrt(clamp(cosView, 0.0f, 1.0f)) * float(kFresnelTableWidth - 1),
              sqrt(clamp(deviation / kFresnelMaxDeviation, 0.0f, 1.0f)) * float(kFresnelTableHeight - 1));
}

PELAGIC_PHYSICS_END
#endif
