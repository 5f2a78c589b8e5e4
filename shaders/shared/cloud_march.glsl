// The clouds along a ray. Before it: `light`, a SkyLight.
#ifndef PELAGIC_SHARED_CLOUD_MARCH_GLSL
#define PELAGIC_SHARED_CLOUD_MARCH_GLSL
#include "physics/clouds.glsl"
#include "shared/sky_pass.h"

struct CloudsSeen {
  vec3 light;           // of the clouds
  float transmittance;  // of what is behind
  float distance;       // mean, of what is seen of them [m]
};

// Light of the surroundings within the layer, `height` from base 0 to top 1: of the sky above what the clouds there let through,
// from below the sea and the air over it, which send a tenth back.
vec3 cloudAmbient(float height, float q) {
  vec3 sky = light.skyIrradiance.rgb;
  vec3 sea = 0.1 * (sky + light.sunIrradiance.rgb * max(light.sunDirection.y, 0.0));
  return (sky * cloudDiffuse(q, light.sunDirection.y) + sea * mix(1.0, 0.35, height)) * (0.5 / kAirPi);
}

// `d`: unit, `place`: of the eye [tiles], `finest`: step where there are clouds [m], `farther`: of the distance, which steps are
// at least where the layer bounds them no more, `pixel`: angular size [rad], `steps`: at most. The field tells how far off the
// next cloud is at least: it changes by 1 in 150 m along the layer; across it, no step passes more than an eighth of it, and
// none that meets clouds more than a thirty-second. `openSea`: what the weather takes off the field at most, in the middle of
// the way, since it changes over tens of kilometres.
CloudsSeen cloudsAlong(sampler3D volume, sampler3D detail, vec3 d, float altitude, vec2 place, float base, float top,
                       float openSea, float finest, float farther, float pixel, int steps) {
  const float kFieldScale = 150.0;
  const float kLargestBubble = 0.25 * kCloudDetailTile, kSmallestBubble = 45.0;
  vec2 span = cloudSpan(altitude, d.y, base, top);
  float most = 0.125 * (top - base) / max(abs(d.y), 0.02);
  // A thin layer has a few steps at least.
  float coarsest = 0.25 * (span.y - span.x);
  float mu = dot(d, light.sunDirection.xyz);
  float weather = openSea * cloudWeather(place + d.xz * (0.5 * (span.x + span.y) / kCloudTile));
  CloudsSeen seen = CloudsSeen(vec3(0), 1.0, 0.0);
  vec2 cloud = vec2(0, 1);
  float t = span.x, step = 0.0, next = 0.0, field = -1.0;
  int i = 0;
  while (i < steps && t < span.y && seen.transmittance > 0.01) {
    vec3 at;
    float h, least, before, lit, blur;
    // On to where there may be clouds, torn or not, on the way from the last sample.
    do {
      before = field;
      lit = cloud.g;
      step = next;
      t += step;
      h = altitudeAlong(altitude, d.y, t);
      at = vec3(place + d.xz * (t / kCloudTile), (h - base) / (top - base));
      cloud = textureLod(volume, at, 0).rg;
      cloud.r -= weather;
      // A pixel's width, where the field changes by 1 in twice its least way; it has a deviation of 1.
      blur = min(0.5 * pixel * t / kFieldScale, 0.5);
      // Far off, steps grow with the distance.
      least = min(max(finest, min(farther * t, 0.25 * most)), coarsest);
      field = tornField(cloud.r, kLeastHole);
      next = min(clamp(-kFieldScale * field, least, max(least, most)), span.y - t);
    } while (++i < steps && max(before, field) < -blur && t < span.y);
    // Bubbles smaller than steps or than a pixel are left out.
    float hole = textureLod(detail, vec3(at.xy * (kCloudTile / kCloudDetailTile), h / kCloudDetailTile), 0).r;
    float kept = clamp(1.5 - max(t * pixel / kSmallestBubble, least / kLargestBubble), 0.0, 1.0);
    field = tornField(cloud.r, mix(kMeanHole, hole, kept));
    float density = cloudDensityBetween(min(before, field) - blur, max(before, field) + blur);
    float taken = seen.transmittance * (1.0 - exp(-kCloudExtinction * density * step));
    float halfway = 0.5 * step;
    float middle = clamp(at.z - halfway * d.y / (top - base), 0.0, 1.0);
    float q = 0.5 * (lit + cloud.g);
    q = mix(q, sqrt(q), weather);  // clouds held down are half as deep on the sun's way
    vec3 source = light.cloudSun.rgb * cloudScattering(mu, q, light.sunDirection.y) + cloudAmbient(middle, q);
    seen.light += taken * source;
    seen.distance += taken * (t - halfway);
    seen.transmittance -= taken;
  }
  seen.distance /= max(1.0 - seen.transmittance, 1e-4);
  return seen;
}

// Through the air before them: `air`, what it adds per what it takes in their direction.
vec3 cloudsThroughAir(CloudsSeen seen, float altitude, float base, float top, vec3 air) {
  float h = 0.5 * (base + top);
  vec3 extinction = light.rayleighExtinction.rgb * meanDensityBetween(altitude, h, light.rayleighExtinction.w) +
                    light.mieExtinction.rgb * meanDensityBetween(altitude, h, light.mieExtinction.w);
  vec3 clear = exp(-extinction * seen.distance);
  return seen.light * clear + (1.0 - seen.transmittance) * (1.0 - clear) * air;
}

#endif
