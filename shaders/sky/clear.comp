#version 460
// Radiance of the clear sky from sea level, relative to the sun's azimuth (it is symmetric about it).
#extension GL_GOOGLE_include_directive : require
#include "pelagic/shader/types.h"
#include "physics/atmosphere.glsl"
#include "shared/sky_pass.h"
#include "air_lookup.glsl"

const int kSteps = 32;
// Airglow and starlight without a moon, 22 mag/arcsec^2 = 1.7e-4 cd/m^2 of 1.28e5 lx.
const vec3 kNight = vec3(1.3e-9);

layout(local_size_x = kSkyTile, local_size_y = kSkyTile) in;
layout(push_constant) uniform Push { SkyPass pass; };
layout(binding = 0) uniform sampler2D transmittance;
layout(binding = 1, std430) readonly buffer Scattering { vec4 scattering[]; };
layout(binding = 2) writeonly uniform image2D clear;

// Bilinear; half floats would lose the twilight.
vec3 manyTimesScattered(float h, float mu) {
  vec2 place = scatteringPlace(h, mu) * vec2(kScatteringWidth - 1, kScatteringHeight - 1);
  uvec2 low = min(uvec2(place), uvec2(kScatteringWidth - 2, kScatteringHeight - 2));
  vec2 f = place - vec2(low);
  uint i = low.y * kScatteringWidth + low.x;
  return mix(mix(scattering[i].rgb, scattering[i + 1].rgb, f.x),
             mix(scattering[i + kScatteringWidth].rgb, scattering[i + kScatteringWidth + 1].rgb, f.x), f.y);
}

vec3 radiance(float viewMu, float sunMu, float sunView) {
  float end = distanceToTop(0.0, viewMu);
  float rayleigh = rayleighPhase(sunView), mie = miePhase(sunView);
  vec3 through = vec3(1), light = vec3(0);
  for (int i = 0; i < kSteps; ++i) {
    float a = float(i) / float(kSteps), b = float(i + 1) / float(kSteps), m = 0.5 * (a + b);
    float t = end * m * m;  // dense near the eye
    float h = clamp(altitudeAlong(0.0, viewMu, t), 0.0, kAirTop);
    float mu = (kEarthRadius * sunMu + t * sunView) / (kEarthRadius + h);
    vec3 density = airDensity(h);
    vec3 extinction = airExtinction(density, pass.haze);
    vec3 molecules = kRayleighScattering * density.x, aerosols = mieScattering(density, pass.haze);
    vec3 source = (molecules * rayleigh + aerosols * mie) * sunlightAt(transmittance, h, mu) +
                  (molecules + aerosols) * manyTimesScattered(h, mu);
    vec3 stepThrough = exp(-extinction * (end * (b * b - a * a)));
    light += source * through * (1.0 - stepThrough) / max(extinction, vec3(1e-12));
    through *= stepThrough;
  }
  return light;
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  vec2 place = (vec2(texel) + 0.5) / float(kClearSize);
  float azimuth = kAirPi * place.x * place.x;
  float elevation = 0.5 * kAirPi * place.y * place.y;
  float sunMu = pass.sunDirection.y, sunSide = sqrt(max(0.0, 1.0 - sunMu * sunMu));
  float sunView = sin(elevation) * sunMu + cos(elevation) * sunSide * cos(azimuth);
  vec3 light = (radiance(sin(elevation), sunMu, sunView) + kNight) * pass.gain;
  imageStore(clear, texel, vec4(light, 1));
}
