// Air and clouds between the eye and what a pixel shows, the same for the sea and for the host's objects.
#ifndef PELAGIC_COMPOSITE_AIR_GLSL
#define PELAGIC_COMPOSITE_AIR_GLSL
#include "composite/sky_lookup.glsl"
#include "physics/air_path.glsl"

// Height of a point over the still sea below it [m], `place` from the eye [m]. Summed without the square of the radius.
float heightOverSea(vec3 place) {
  float radius = frame.planetRadius, eye = frame.absorption.w;
  float q = eye * (2.0 * radius + eye) + dot(place, place) + 2.0 * (radius + eye) * place.y;
  return q / (sqrt(radius * radius + q) + radius);
}

// Place in the radiance map of the air's own light before a point in the direction d: below the horizon, also where the point
// stands over it.
vec2 airPlace(vec3 d) { return skyPlace(vec3(d.x, min(d.y, (frame.thickCrest.w - 1e-4) * length(d.xz)), d.z)); }

// Transmittance of the air between the eye and a point `distance` [m] away, `height` >= 0 over the sea.
vec3 airTransmittance(float distance, float height) {
  float eye = max(frame.absorption.w, 0.0);
  float low = min(eye, height), high = max(eye, height);
  vec3 extinction = light.rayleighExtinction.rgb * meanDensityBetween(low, high, light.rayleighExtinction.w) +
                    light.mieExtinction.rgb * meanDensityBetween(low, high, light.mieExtinction.w);
  return exp(-extinction * distance);
}

vec3 throughAir(vec3 radiance, vec2 place, float distance, float height) {
  return mix(skyRadiance(place), radiance, airTransmittance(distance, height));
}

// Light of the clouds in a pixel before a point `height` over the sea, and their transmittance: those of the whole layer, where
// the point is behind it, and as of an even layer where it is within.
vec4 cloudsBefore(ivec2 pixel, float height) {
  if (!kHasClouds) return vec4(0, 0, 0, 1);
  float share = layerShareBefore(frame.absorption.w, height, light.cloudPlace.w, light.cloudSun.w);
  vec4 clouds = cloudsBefore(pixel);
  if (share >= 1.0) return clouds;
  float through = pow(max(clouds.a, 1e-3), share);
  // Of clouds too thin for the quotient's digits, the share itself.
  float part = clouds.a > 0.999 ? share : (1.0 - through) / (1.0 - clouds.a);
  return vec4(clouds.rgb * part, through);
}

#endif
