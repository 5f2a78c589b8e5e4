// From scene radiance to 8-bit display values.
#ifndef PELAGIC_PHYSICS_TONE_GLSL
#define PELAGIC_PHYSICS_TONE_GLSL
#include "physics/formula.h"

PELAGIC_PHYSICS_BEGIN

// A film-like curve, per channel: x^a / (x^a + s), the Naka-Rushton response (1966) with a = 5/4, s = 0.18^a (1/0.18 - 1).
// Middle grey 0.18 stays 0.18, the toe deepens shadows, the shoulder nears 1 without reaching it: 1 gives 0.65, 16 gives
// 0.98. Grey stays grey.
PELAGIC_FORMULA vec3 filmCurve(vec3 x) {
  vec3 p = x * sqrt(sqrt(x));
  return p / (p + 0.5341116f);
}

// The sRGB encoding of 0 ... 1. Roots instead of pow(x, 1/2.4), fitted to the standard's curve: within 6e-5.
PELAGIC_FORMULA vec3 encodeSrgb(vec3 x) {
  vec3 a = sqrt(x);
  vec3 b = sqrt(a);
  vec3 c = sqrt(b);
  vec3 high = 0.6423636f * a + 0.7121128f * b - 0.3368709f * c - 0.0175624f * x;
  return mix(high, 12.92f * x, vec3(lessThanEqual(x, vec3(0.0031308f))));
}

// What a pixel counts in the metering: its luminance in stops. Black and the sun's disc count as the ends of what a picture
// can show around middle grey, lest a few pixels turn all.
PELAGIC_FORMULA float meteredStops(vec3 radiance) {
  float luminance = dot(radiance, vec3(0.2126f, 0.7152f, 0.0722f));
  return log2(clamp(luminance, 1e-5f, 100.0f));
}

// Exposure [EV] that brings a mean of so many stops to middle grey, 0.18.
PELAGIC_FORMULA float meteredExposure(float stops) { return -2.4739312f - stops; }

PELAGIC_PHYSICS_END
#endif
