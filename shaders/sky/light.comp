#version 460
// The light of the sky as numbers: integrates the clear sky over the hemisphere and weighs in the clouds.
#extension GL_GOOGLE_include_directive : require
#include "pelagic/shader/types.h"
#include "physics/atmosphere.glsl"
#include "physics/moon.glsl"
#include "pelagic/shader/sky_light.h"
#include "shared/sky_pass.h"

const uint kThreads = 256;
// Share of the clear sky's global irradiance that a closed cloud cover lets through (stratus about 0.25, altostratus
// 0.4), and its colour at luminance 1: a little bluer than the sun.
const float kCloudTransmittance = 0.3;
const vec3 kCloudTint = vec3(0.953, 1.003, 1.106);
const vec3 kLuminance = vec3(0.2126, 0.7152, 0.0722);

const float kSunCosine = 0.99998907;  // of kSunAngularRadius; cos() of a device may not resolve it

layout(local_size_x = kThreads) in;
layout(push_constant) uniform Push { SkyPass pass; };
layout(binding = 0) uniform sampler2D clear;
layout(binding = 1, std430) writeonly buffer Light { SkyLight light; };
layout(binding = 2) uniform sampler2D moonlit;

shared vec3 partial[kThreads];

// Irradiance on the horizontal from the texels of this invocation; a texel counts with its exact projected solid angle,
// both sides of the sun.
vec3 irradianceOfTexels(uint first) {
  const float n = float(kClearSize);
  vec3 sum = vec3(0);
  for (uint i = first; i < kClearSize * kClearSize; i += kThreads) {
    vec2 low = vec2(i % kClearSize, i / kClearSize) / n, high = low + 1.0 / n;
    vec2 sines = sin(0.5 * kAirPi * vec2(low.y * low.y, high.y * high.y));
    float weight = 0.5 * (sines.y * sines.y - sines.x * sines.x) * 2.0 * kAirPi * (high.x * high.x - low.x * low.x);
    ivec2 texel = ivec2(i % kClearSize, i / kClearSize);
    sum += weight * (texelFetch(clear, texel, 0).rgb + kMoonTint * texelFetch(moonlit, texel, 0).rgb);
  }
  return sum;
}

// Of the light's own colour, at sea level; the middle of what stands above the horizon, so that a setting disc reddens to the
// end.
vec3 throughTheAir(float elevation) {
  float middle = 0.5 * (max(elevation - kSunAngularRadius, 0.0) + max(elevation + kSunAngularRadius, 0.0));
  return exp(-airOpticalDepth(0.0, sin(middle), pass.haze, 64));
}

void writeLight(vec3 clearSky) {
  bool byMoon = pass.sunPlace.w > 0.0;
  vec4 source = byMoon ? vec4(pass.moonDirection.xyz, asin(clamp(pass.moonDirection.y, -1.0, 1.0))) : pass.sunDirection;
  // Over the air.
  vec3 moonlight = kMoonTint * (pass.moonDirection.w * pass.gain);
  vec3 strength = byMoon ? moonlight : vec3(1);
  float elevation = source.w;
  vec3 sun = throughTheAir(elevation) * strength;
  float share = sunDiscShare(elevation);
  vec3 global = clearSky + sun * (share * max(sin(elevation), 0.5 * kSunAngularRadius));
  vec3 cloudy = kCloudTint * (kCloudTransmittance * dot(global, kLuminance)) * pass.overcast;
  float open = 1.0 - pass.overcast;
  vec3 sunNow = sun * open * (share > 0.0 ? 1.0 : 0.0);
  const float disc = kAirPi * kSunAngularRadius * kSunAngularRadius;
  light.sunDirection = vec4(source.xyz, kSunCosine);
  light.sunIrradiance = vec4(sunNow * share, 0);
  light.sunRadiance = vec4(sunNow / disc, byMoon ? 0.0 : 1.0);
  light.skyIrradiance = vec4(clearSky * open + cloudy, pass.gain);
  light.rayleighExtinction = vec4(kRayleighScattering, kRayleighHeight);
  light.mieExtinction = vec4(kMieExtinction * pass.haze.x, pass.haze.y);
  // The CIE overcast sky gives 7 pi/9 of its zenith's radiance.
  light.cloudZenith = vec4(cloudy * (9.0 / (7.0 * kAirPi)), 0);
  // Clouds see the sun a little longer than the sea does.
  float mu = sin(elevation);
  vec3 above = exp(-airOpticalDepth(pass.altitude, max(mu, horizonCosine(pass.altitude)), pass.haze, 64));
  vec3 high = byMoon ? strength : vec3(pass.gain);
  light.cloudSun = vec4(above * high * (open * sunVisibility(pass.altitude, mu)), 1e9);
  float moonElevation = asin(clamp(pass.moonDirection.y, -1.0, 1.0));
  light.moonDirection = vec4(pass.moonDirection.xyz, open);
  // What is lit of the disc is as bright as at full moon; thinner phases are darker in truth.
  float full = pass.moonDirection.w > 0.0 ? kFullMoon * pass.gain * open / disc : 0.0;
  light.moonRadiance = vec4(kMoonTint * throughTheAir(moonElevation) * full, 0);
  light.moonLit = vec4(pass.sunPlace.xyz, 0);
  light.stars = pass.stars;
  light.cloudPlace = vec4(0, 0, 0, 1e9);
}

void main() {
  uint i = gl_LocalInvocationIndex;
  partial[i] = irradianceOfTexels(i);
  for (uint half_ = kThreads / 2; half_ > 0; half_ /= 2) {
    barrier();
    if (i < half_) partial[i] += partial[i + half_];
  }
  if (i == 0) writeLight(partial[0]);
}
