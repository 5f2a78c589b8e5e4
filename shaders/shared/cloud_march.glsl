// The clouds along a ray. Before it: `light`, a SkyLight.
#ifndef PELAGIC_SHARED_CLOUD_MARCH_GLSL
#define PELAGIC_SHARED_CLOUD_MARCH_GLSL
#include "physics/clouds.glsl"
#include "shared/sky_pass.h"

struct CloudsSeen {
  vec3 light;           // of the clouds and of the air before them
  float transmittance;  // of what is behind
};

// Light of the surroundings within the layer, `height` from base 0 to top 1: the sky above, below the sea and the air over it,
// which send a tenth back.
vec3 cloudAmbient(float height) {
  vec3 sky = light.skyIrradiance.rgb;
  vec3 sea = 0.1 * (sky + light.sunIrradiance.rgb * max(light.sunDirection.y, 0.0));
  return (sky * mix(0.35, 1.0, height) + sea * mix(1.0, 0.35, height)) * (0.5 / kAirPi);
}

// `d`: unit, `place`: of the eye in the tile, `air`: what the air adds per what it takes in the direction, `finest`: step
// where there are clouds [m], `pixel`: angular size [rad], `steps`: at most. The field tells how far off the next cloud is at
// least: it changes by 1 in 150 m along the layer; across it, no step passes more than an eighth of it.
CloudsSeen cloudsAlong(sampler3D volume, sampler3D detail, vec3 d, float altitude, vec2 place, float base, float top,
                       vec3 air, float finest, float pixel, int steps) {
  const float kFieldScale = 150.0, kFarther = 0.02, kTorn = 1.1;
  const float kLargestBubble = 0.25 * kCloudDetailTile, kSmallestBubble = 45.0, kMeanHole = 0.5;
  vec2 span = cloudSpan(altitude, d.y, base, top);
  float most = 0.125 * (top - base) / max(abs(d.y), 0.02);
  float mu = dot(d, light.sunDirection.xyz);
  vec3 seen = vec3(0);
  float through = 1.0, distance = 0.0;
  // A thin layer has a few steps at least.
  float coarsest = 0.25 * (span.y - span.x);
  float t = span.x + 0.5 * min(max(finest, kFarther * span.x), coarsest);
  int i = 0;
  do {
    float h = altitudeAlong(altitude, d.y, t);
    vec3 at = vec3(place + d.xz * (t / kCloudTile), (h - base) / (top - base));
    vec2 cloud = textureLod(volume, at, 0).rg;
    float holes = textureLod(detail, vec3(at.xy * (kCloudTile / kCloudDetailTile), h / kCloudDetailTile), 0).r;
    // Far off, steps grow with the distance, and bubbles smaller than they or than a pixel are left out.
    float least = min(max(finest, kFarther * t), coarsest);
    float step = min(clamp(-kFieldScale * cloud.r, least, max(least, most)), max(span.y - t, 0.5 * least));
    float kept = clamp(1.5 - max(t * pixel / kSmallestBubble, least / kLargestBubble), 0.0, 1.0);
    float density = t < span.y ? cloudDensity(cloud.r - kTorn * (mix(kMeanHole, holes, kept) - 0.3)) : 0.0;
    float taken = 1.0 - exp(-kCloudExtinction * density * step);
    vec3 source = light.cloudSun.rgb * cloudScattering(mu, cloud.g) + cloudAmbient(clamp(at.z, 0.0, 1.0));
    seen += through * taken * source;
    distance += through * taken * t;
    through *= 1.0 - taken;
    t += step;
  } while (++i < steps && t < span.y && through > 0.01);
  float cover = 1.0 - through;
  float away = distance / max(cover, 1e-4);
  float h = 0.5 * (base + top);
  vec3 extinction = light.rayleighExtinction.rgb * meanDensityBetween(altitude, h, light.rayleighExtinction.w) +
                    light.mieExtinction.rgb * meanDensityBetween(altitude, h, light.mieExtinction.w);
  vec3 clear = exp(-extinction * away);
  return CloudsSeen(seen * clear + cover * (1.0 - clear) * air, through);
}

#endif
