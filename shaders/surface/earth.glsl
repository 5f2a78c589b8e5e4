// The curved sea level.
#ifndef PELAGIC_SURFACE_EARTH_GLSL
#define PELAGIC_SURFACE_EARTH_GLSL

const float kEarthRadius = 6371000;  // as in pelagic/camera.hpp [m]

// How far the sea level lies below the tangent plane at the squared horizontal distance r2 [m^2], without cancellation.
float curvatureDrop(float r2) {
  return r2 / (kEarthRadius + sqrt(max(kEarthRadius * kEarthRadius - r2, 0.0)));
}

#endif
