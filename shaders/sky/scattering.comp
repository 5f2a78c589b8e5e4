#version 460
// Light scattered twice and more, after Hillaire (2020), section 5.5: second-order light is taken as isotropic and every
// further order as the same fraction of the one before. One work-group a texel, one direction an invocation.
#extension GL_GOOGLE_include_directive : require
#include "pelagic/shader/types.h"
#include "physics/atmosphere.glsl"
#include "shared/sky_pass.h"
#include "air_lookup.glsl"

const uint kDirections = 64;
const int kSteps = 20;
layout(local_size_x = kDirections) in;
layout(push_constant) uniform Push { SkyPass pass; };
layout(binding = 0) uniform sampler2D transmittance;
layout(binding = 1, std430) writeonly buffer Scattering { vec4 scattering[]; };

shared vec3 secondOrder[kDirections];
shared vec3 transfer[kDirections];

// 8 x 8 directions, dense at the horizon, where a twilight's light is; w their share of the sphere. The sun lies in the
// plane of symmetry, so half the sphere is enough.
vec4 directionOf(uint index) {
  float s = (float(index / 8) + 0.5) / 4.0 - 1.0;
  float mu = s * abs(s);
  float azimuth = kAirPi * (float(index % 8) + 0.5) / 8.0;
  float side = sqrt(1.0 - mu * mu);
  return vec4(side * cos(azimuth), mu, side * sin(azimuth), 2.0 * abs(s) / 64.0);
}

void march(float h, vec4 direction, float sunMu, uint slot) {
  float ground = distanceToGround(h, direction.y);
  float end = ground >= 0.0 ? ground : distanceToTop(h, direction.y);
  float sunView = direction.x * sqrt(max(0.0, 1.0 - sunMu * sunMu)) + direction.y * sunMu;
  vec3 through = vec3(1), light = vec3(0), fraction = vec3(0);
  for (int i = 0; i < kSteps; ++i) {
    float a = float(i) / float(kSteps), b = float(i + 1) / float(kSteps), m = 0.5 * (a + b);
    float t = end * m * m;
    float height = clamp(altitudeAlong(h, direction.y, t), 0.0, kAirTop);
    float mu = ((kPlanetRadius + h) * sunMu + t * sunView) / (kPlanetRadius + height);
    vec3 density = airDensity(height, pass.haze);
    vec3 extinction = airExtinction(density);
    vec3 scattered = kRayleighScattering * density.x + mieScattering(density);
    vec3 stepThrough = exp(-extinction * (end * (b * b - a * a)));
    // Exact along the step when the medium is constant in it.
    vec3 share = scattered * through * (1.0 - stepThrough) / max(extinction, vec3(1e-12));
    light += share * sunlightAt(transmittance, height, mu) / (4.0 * kAirPi);
    fraction += share;
    through *= stepThrough;
  }
  if (ground >= 0.0) {
    float mu = ((kPlanetRadius + h) * sunMu + ground * sunView) / kPlanetRadius;
    light += through * sunlightAt(transmittance, 0.0, mu) * (max(mu, 0.0) * kAirAlbedo / kAirPi);
  }
  secondOrder[slot] = light * direction.w;
  transfer[slot] = fraction * direction.w;
}

void main() {
  uint slot = gl_LocalInvocationIndex;
  vec2 place = vec2(gl_WorkGroupID.xy) / vec2(kScatteringWidth - 1, kScatteringHeight - 1);
  vec2 point = scatteringPoint(place);
  march(min(point.x, kAirTop - 1.0), directionOf(slot), point.y, slot);
  for (uint half_ = kDirections / 2; half_ > 0; half_ /= 2) {
    barrier();
    if (slot < half_) {
      secondOrder[slot] += secondOrder[slot + half_];
      transfer[slot] += transfer[slot + half_];
    }
  }
  if (slot == 0) {
    scattering[gl_WorkGroupID.y * kScatteringWidth + gl_WorkGroupID.x] = vec4(secondOrder[0] / (1.0 - transfer[0]), 0);
  }
}
