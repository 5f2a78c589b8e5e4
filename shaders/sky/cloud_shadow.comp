#version 460
// The share of the sun's light that comes through the clouds to sea level, over one tile: where the weather holds
// no clouds down, and where it does its most.
#extension GL_GOOGLE_include_directive : require
#include "physics/clouds.glsl"
#include "shared/sky_pass.h"

const int kSteps = 32;

layout(local_size_x = kSkyTile, local_size_y = kSkyTile) in;
layout(push_constant) uniform Push { CloudPass pass; };
layout(binding = 0) uniform sampler3D field;
layout(binding = 1) uniform writeonly image2D shadow;
layout(binding = 2) uniform sampler3D detail;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  vec2 p = (vec2(texel) + 0.5) / float(kCloudCells);
  vec3 sun = pass.sunDirection.xyz;
  // A sun at the horizon comes through many clouds: held where its way is 20 thicknesses long.
  float climb = max(sun.y, 1.0 / kCloudLongest);
  vec2 depth = vec2(0);
  float step = pass.thickness / (climb * float(kSteps));
  for (int i = 0; i < kSteps; ++i) {
    float height = (float(i) + 0.5) / float(kSteps);
    float t = (pass.base + height * pass.thickness) / climb;
    vec3 at = vec3(p + t * sun.xz / kCloudTile, height);
    vec3 torn = vec3(at.xy * kCloudTile, pass.base + height * pass.thickness) / kCloudDetailTile;
    float there = tornField(textureLod(field, at, 0).r, textureLod(detail, torn, 0).r);
    depth += vec2(cloudDensity(there), cloudDensity(there - pass.openSea)) * step;
  }
  imageStore(shadow, texel, vec4(exp(-kCloudDimming * kCloudExtinction * depth), 0, 0));
}
