#version 460
// The shape of the clouds: a field whose 0 is the clouds' edge, over one tile of the layer.
#extension GL_GOOGLE_include_directive : require
#include "physics/clouds.glsl"
#include "physics/noise.glsl"
#include "shared/sky_pass.h"

layout(local_size_x = kSkyTile, local_size_y = kSkyTile) in;
layout(push_constant) uniform Push { CloudPass pass; };
layout(binding = 0) uniform writeonly image3D field;
layout(binding = 1) uniform sampler3D detail;

const uint kLargestCells = 4u;  // of the tile: 3.8 km
const uint kOctaves = 3u;
// Fields of clouds 4 km across hold most of it: with more in the last octave, low covers are beads.
const float kWeights[] = {1.0, 0.8, 0.5};
const float kHeadsWeight = 0.42;  // of a unit deviation of the octaves

void main() {
  uvec3 cell = gl_GlobalInvocationID;
  vec3 size = vec3(kCloudCells, kCloudCells, kCloudLayers);
  vec3 p = (vec3(cell) + 0.5) / size;
  float height = p.z * pass.thickness;
  vec3 q = vec3(p.xy, height / kCloudTile) * float(kLargestCells) + vec3(0, 0, 17.0 * float(pass.seed));
  uvec2 cells = uvec2(kLargestCells);
  float sum = 0.0, squares = 0.0;
  vec2 stirred = vec2(0);
  for (uint octave = 0u; octave < kOctaves; ++octave) {
    const float kDeviation = 0.185;  // of one octave
    float noise = (latticeNoise(q, cells) - 0.5) / kDeviation;
    sum += kWeights[octave] * noise;
    squares += kWeights[octave] * kWeights[octave];
    stirred = vec2(stirred.y, noise);
    q = 2.0 * q + vec3(0, 0, 31.0);
    cells *= 2u;
  }
  // Heads: the bubbles of the edges, four times as large.
  const float kHeads = 4.0 * kCloudDetailTile, kHeadsDeviation = 0.114;
  vec3 head = vec3(p.xy * kCloudTile, height + 0.37 * kHeads * float(pass.seed)) / kHeads;
  float bubbles = (kMeanHole - textureLod(detail, head + vec3(0.1 * stirred, 0), 0).r) / kHeadsDeviation;
  float large = sum * inversesqrt(squares);
  // They grow on clouds only: elsewhere they would stand alone, as beads.
  float heads = kHeadsWeight * smoothstep(-0.8, 0.4, large - pass.threshold);
  float normal = (large + heads * bubbles) * inversesqrt(1.0 + heads * heads);
  // Clouds rise from a flat base as far as they are strong.
  float profile = 2.5 * p.z * p.z + 3.0 * (1.0 - smoothstep(0.0, 0.12, p.z));
  imageStore(field, ivec3(cell), vec4(clamp(normal - pass.threshold - profile, -4.0, 4.0), 0, 0, 0));
}
