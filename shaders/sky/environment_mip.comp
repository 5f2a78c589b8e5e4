#version 460
// One mip of the environment from the one above, filtered by the binomial (1 3 3 1)/8 in both directions: four bilinear
// samples, each between weights 3 and 1. The sum over the map is kept.
#extension GL_GOOGLE_include_directive : require
#include "pelagic/shader/types.h"
#include "shared/sky_pass.h"

layout(local_size_x = kSkyTile, local_size_y = kSkyTile) in;
layout(binding = 0) uniform sampler2D finer;
layout(binding = 1) writeonly uniform image2D coarser;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(coarser);
  if (any(greaterThanEqual(texel, size))) return;
  vec2 centre = (vec2(texel) + 0.5) / vec2(size);
  vec2 tap = 0.375 / vec2(size);  // 0.75 of a texel of the finer mip
  vec4 sum = textureLod(finer, centre + tap * vec2(-1, -1), 0) + textureLod(finer, centre + tap * vec2(1, -1), 0) +
             textureLod(finer, centre + tap * vec2(-1, 1), 0) + textureLod(finer, centre + tap * vec2(1, 1), 0);
  imageStore(coarser, texel, 0.25 * sum);
}
