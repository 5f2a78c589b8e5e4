// The curved sea level.
#ifndef PELAGIC_SURFACE_EARTH_GLSL
#define PELAGIC_SURFACE_EARTH_GLSL

#include "pelagic/shader/constants.h"

// How far the sea level lies below the tangent plane at the squared horizontal distance r2 [m^2], without cancellation.
float curvatureDrop(float r2) {
  return r2 / (kEarthRadius + sqrt(max(kEarthRadius * kEarthRadius - r2, 0.0)));
}

#endif
