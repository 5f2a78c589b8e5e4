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
  // The sun; once it is 2 degrees below the horizon, the moon, if it is up.
  vec4 sunDirection;   // xyz toward it (world), w cosine of the disc's angular radius
  vec4 sunIrradiance;  // rgb at sea level on a plane facing the sun, without the clouds' shadow; 0 when it is below the
                       // horizon
  vec4 sunRadiance;    // rgb of the disc as seen from sea level, w 1 for the sun, 0 for the moon
  vec4 skyIrradiance;  // rgb on a horizontal plane from the sky without the sun, w twilight gain (pelagic/sky.hpp)
  vec4 rayleighExtinction;  // rgb at sea level [1/m], w scale height [m]
  vec4 mieExtinction;       // rgb at sea level [1/m], w scale height [m]
  vec4 cloudZenith;  // rgb radiance at the zenith of the overcast sky's share, w how far the weather over the eye holds
                     // clouds down, 0 ... 1
  vec4 cloudSun;     // rgb irradiance on a plane facing the sun at the clouds' altitude, w their highest tops [m], 1e9
                     // without clouds
  vec4 moonDirection;  // xyz toward the moon (world), w share of the starlight that the overcast lets through
  vec4 moonRadiance;   // rgb of the lit part of its disc as seen from sea level; 0 below the horizon
  vec4 moonLit;        // xyz from the moon toward the sun (world)
  vec4 stars;          // quaternion xyzw that turns world directions into the sky of the stars
  vec4 cloudPlace;  // xy place of the eye in the clouds' shadow [tiles], z tiles per metre, w base of the clouds [m],
                    // 1e9 without
};

PELAGIC_SHADER_END

#endif
