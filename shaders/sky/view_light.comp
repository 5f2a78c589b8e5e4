#version 460
// The sky's light around an eye: that of the cloudless sky, with the irradiance of the environment that holds the clouds.
#extension GL_GOOGLE_include_directive : require
#include "pelagic/shader/sky_light.h"
#include "physics/cloud_weather.glsl"
#include "shared/sky_pass.h"

const uint kThreads = 256;
layout(local_size_x = kThreads) in;
layout(push_constant) uniform Push { CloudView view; };
layout(binding = 0) uniform sampler2D environment;
layout(binding = 1, std430) readonly buffer Sky { SkyLight sky; };
layout(binding = 2, std430) writeonly buffer Light { SkyLight light; };

const int kMip = 1;
shared vec3 partial[kThreads];

// L cos(zenith angle) dw over the disc: dw = 4/(1 + q^2)^2 dq, cos = (1 - q^2)/(1 + q^2).
vec3 irradianceOfTexels(uint first) {
  const uint size = kEnvironmentSize >> kMip;
  const float side = 2.0 / (float(size) * kEnvironmentScale);
  vec3 sum = vec3(0);
  for (uint i = first; i < size * size; i += kThreads) {
    vec2 q = ((vec2(i % size, i / size) + 0.5) / float(size) * 2.0 - 1.0) / kEnvironmentScale;
    float s = dot(q, q);
    float weight = max(1.0 - s, 0.0) * 4.0 / ((1.0 + s) * (1.0 + s) * (1.0 + s)) * side * side;
    sum += weight * texelFetch(environment, ivec2(i % size, i / size), kMip).rgb;
  }
  return sum;
}

void main() {
  uint i = gl_LocalInvocationIndex;
  partial[i] = irradianceOfTexels(i);
  for (uint half_ = kThreads / 2; half_ > 0; half_ /= 2) {
    barrier();
    if (i < half_) partial[i] += partial[i + half_];
  }
  if (i == 0) {
    SkyLight seen = sky;
    if (view.cover > 0.0) seen.skyIrradiance.rgb = partial[0];
    seen.cloudPlace = vec4(view.place, 1.0 / kCloudTile, view.cover > 0.0 ? view.rayX.w : seen.cloudPlace.w);
    seen.cloudZenith.w =
        cloudWeather(cloudsTowardSun(view.place, sky.sunDirection.xyz, view.rayX.w, view.rayY.w, 1.0 / kCloudTile));
    seen.cloudSun.w = view.cover > 0.0 ? view.rayY.w : seen.cloudSun.w;
    light = seen;
  }
}
