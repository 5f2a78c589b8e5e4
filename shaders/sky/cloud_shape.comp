#version 460
// The shape of the clouds: a field whose 0 is the clouds' edge, over one tile of the layer.
#extension GL_GOOGLE_include_directive : require
#include "physics/noise.glsl"
#include "shared/sky_pass.h"

layout(local_size_x = kSkyTile, local_size_y = kSkyTile) in;
layout(push_constant) uniform Push { CloudPass pass; };
layout(binding = 0) uniform writeonly image3D field;

const float kLargest = 0.125;  // of the tile: 1.9 km
const uint kOctaves = 5u;

void main() {
  uvec3 cell = gl_GlobalInvocationID;
  vec3 size = vec3(kCloudCells, kCloudCells, kCloudLayers);
  vec3 p = (vec3(cell) + 0.5) / size;
  float height = p.z * pass.thickness;
  vec3 q = vec3(p.xy / kLargest, height / (kLargest * kCloudTile) + 17.0 * float(pass.seed));
  uvec2 cells = uvec2(uint(1.0 / kLargest));
  float sum = 0.0, squares = 0.0, weight = 1.0;
  for (uint octave = 0u; octave < kOctaves; ++octave) {
    sum += weight * (latticeNoise(q, cells) - 0.5);
    squares += weight * weight;
    q = 2.0 * q + vec3(0, 0, 31.0);
    cells *= 2u;
    weight *= 0.55;
  }
  const float kDeviation = 0.185;  // of one octave
  float normal = sum * inversesqrt(squares) / kDeviation;
  // Clouds rise from a flat base as far as they are strong.
  float profile = 2.5 * p.z * p.z + 3.0 * (1.0 - smoothstep(0.0, 0.12, p.z));
  imageStore(field, ivec3(cell), vec4(clamp(normal - pass.threshold - profile, -4.0, 4.0), 0, 0, 0));
}
