#version 460
// What is torn out of the clouds' edges: bubbles of three sizes (inverted cellular noise, Worley 1996), 0 ... 1.
#extension GL_GOOGLE_include_directive : require
#include "physics/noise.glsl"
#include "shared/sky_pass.h"

layout(local_size_x = kSkyTile, local_size_y = kSkyTile) in;
layout(binding = 0) uniform writeonly image3D detail;

// Distance to the nearest of points scattered one to a cell, repeating after `cells` (a power of two).
float cellular(vec3 p, uint cells) {
  ivec3 base = ivec3(floor(p));
  float nearest = 3.0;
  for (int i = 0; i < 27; ++i) {
    ivec3 at = base + ivec3(i % 3, i / 3 % 3, i / 9) - 1;
    uvec3 id = uvec3(at) & (cells - 1u);
    vec3 point = vec3(latticeValue(id), latticeValue(id + 101u * cells), latticeValue(id + 211u * cells));
    vec3 away = vec3(at) + point - p;
    nearest = min(nearest, dot(away, away));
  }
  return min(sqrt(nearest), 1.0);
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  vec3 p = (vec3(texel) + 0.5) / float(kCloudDetail);
  // Stirred, so that no bubble is a ball.
  const float kTurn = 6.28318531;
  p += 0.04 * sin(kTurn * (2.0 * p.yzx + p.zxy)) + 0.015 * sin(kTurn * (5.0 * p.zxy - 3.0 * p.yzx));
  float holes = 0.55 * cellular(4.0 * p, 4u) + 0.3 * cellular(8.0 * p, 8u) + 0.15 * cellular(16.0 * p, 16u);
  imageStore(detail, texel, vec4(holes, 0, 0, 0));
}
