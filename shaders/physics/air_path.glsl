// What lies in the air and in a layer of clouds along a straight path between two altitudes [m].
#ifndef PELAGIC_PHYSICS_AIR_PATH_GLSL
#define PELAGIC_PHYSICS_AIR_PATH_GLSL
#include "physics/formula.h"

PELAGIC_PHYSICS_BEGIN

// Mean density, relative to sea level, of an exponential atmosphere of scale height H.
PELAGIC_FORMULA float meanDensityBetween(float a, float b, float scaleHeight) {
  float x = (b - a) / scaleHeight;
  float below = exp(-a / scaleHeight);
  return abs(x) < 0.01f ? below * (1.0f - 0.5f * x) : below * (1.0f - exp(-x)) / x;
}

// Of the way through a layer from `base` to `top` that an eye sees which looks past a point: the share that lies before the
// point. A path climbs or falls all along.
PELAGIC_FORMULA float layerShareBefore(float eye, float point, float base, float top) {
  float from = clamp(eye, base, top);
  float whole = (point > eye ? top : base) - from;
  return abs(whole) < 1.0f ? 0.0f : (clamp(point, base, top) - from) / whole;
}

PELAGIC_PHYSICS_END
#endif
