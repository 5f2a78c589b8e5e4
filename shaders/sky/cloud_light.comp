#version 460
// The sun's light within the clouds: the fourth root of its transmittance beside the field.
#extension GL_GOOGLE_include_directive : require
#include "physics/clouds.glsl"
#include "shared/sky_pass.h"

const int kSteps = 10;

layout(local_size_x = kSkyTile, local_size_y = kSkyTile) in;
layout(push_constant) uniform Push { CloudPass pass; };
layout(binding = 0) uniform sampler3D field;
layout(binding = 1) uniform writeonly image3D volume;

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID);
  vec3 p = (vec3(cell) + 0.5) / vec3(kCloudCells, kCloudCells, kCloudLayers);
  vec3 sun = pass.sunDirection.xyz;
  float end = min((1.0 - p.z) * pass.thickness / max(sun.y, 0.05), 6.0 * pass.thickness);
  float depth = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    float a = float(i) / float(kSteps), b = float(i + 1) / float(kSteps);
    float t = 0.5 * end * (a * a + b * b);  // dense near the point
    vec3 at = p + t * vec3(sun.xz / kCloudTile, sun.y / pass.thickness);
    depth += cloudDensity(textureLod(field, at, 0).r) * end * (b * b - a * a);
  }
  float own = texelFetch(field, cell, 0).r;
  imageStore(volume, cell, vec4(own, exp(-0.25 * kCloudExtinction * depth), 0, 0));
}
