// The light of the sky as numbers: written by the sky stage, read by whoever shades, as a storage or a uniform block.
#ifndef PELAGIC_SKY_LIGHT_H
#define PELAGIC_SKY_LIGHT_H
#include "pelagic/shader/types.h"

PELAGIC_SHADER_BEGIN

// Stereographic environment map: uv = 0.5 + 0.5 * kEnvironmentScale * (r.x, r.z) / (1 + r.y); the horizon is a circle
// of radius kEnvironmentScale/2 around the centre, which leaves a rim below the horizon for filtering.
PELAGIC_SHADER_CONSTANT float kEnvironmentScale = 0.8f;

// Radiance in units of the extraterrestrial solar irradiance per steradian (pelagic/sky.hpp).
struct SkyLight {
  vec4 sunDirection;        // xyz toward the sun (world), w cosine of the disc's angular radius
  vec4 sunIrradiance;       // rgb at sea level on a plane facing the sun, clouds included; 0 when below the horizon
  vec4 sunRadiance;         // rgb of the disc as seen from sea level
  vec4 skyIrradiance;       // rgb on a horizontal plane from the sky without the sun, w twilight gain (pelagic/sky.hpp)
  vec4 rayleighExtinction;  // rgb at sea level [1/m], w scale height [m]
  vec4 mieExtinction;       // rgb at sea level [1/m], w scale height [m]
  vec4 cloudZenith;         // rgb radiance at the zenith of the overcast sky's share
  vec4 cloudSun;            // rgb irradiance on a plane facing the sun at the clouds' altitude
  vec4 cloudPlace;  // xy place of the eye in the clouds' shadow [tiles], z tiles per metre, w base of the clouds [m]
};

PELAGIC_SHADER_END

#endif
