#version 460
// Smooths the outlines of waves: their stairs are drawn as the line that they stand for (Reshetov 2009). One invocation a
// pixel of the list that edges.glsl makes.
#extension GL_GOOGLE_include_directive : require
#include "shared/composite.h"

layout(local_size_x = kEdgeGroup) in;
layout(binding = 0) uniform sampler2D shaded;
layout(binding = 1, std430) readonly buffer Edges { uint edgeWords[]; };
layout(binding = 2) uniform writeonly image2D outputImage;

// How far the ends of a step are looked for [px]; longer steps are smoothed near their ends only.
const int kReach = 32;

// Whether the surface breaks off between a pixel and its neighbour at `across`.
bool border(ivec2 place, ivec2 across) {
  if (any(lessThan(place, ivec2(0))) || any(greaterThanEqual(place, textureSize(shaded, 0)))) return false;
  uint bit = across.x < 0 ? kEdgeLeft : across.x > 0 ? kEdgeRight : across.y < 0 ? kEdgeAbove : kEdgeBelow;
  return (uint(texelFetch(shaded, place, 0).a) & bit) != 0u;
}

// One end of a step of the border between the row of a pixel and that at `across`.
struct End {
  float distance;  // from the pixel's centre [px]
  float height;    // +1/2: the line goes into the pixel's own row there, -1/2: out of it
};

End findEnd(ivec2 place, ivec2 across, ivec2 along) {
  int steps = 0;
  while (steps < kReach && border(place + (steps + 1) * along, across)) ++steps;
  ivec2 last = place + steps * along;
  float own = border(last, along) ? 0.5 : 0.0;
  float other = border(last + across, along) ? 0.5 : 0.0;
  return End(float(steps) + 0.5, steps < kReach ? own - other : 0.0);
}

// Share of the pixel beyond the line, which runs from each end to the middle of the step.
float shareBeyond(ivec2 place, ivec2 across) {
  ivec2 along = abs(across.yx);
  End a = findEnd(place, across, -along), b = findEnd(place, across, along);
  float middle = 0.5 * (a.distance + b.distance);
  if (a.distance == b.distance) return 0.125 * (max(a.height, 0.0) + max(b.height, 0.0)) / middle;
  return a.distance < b.distance ? a.height * (1.0 - a.distance / middle) : b.height * (1.0 - b.distance / middle);
}

void main() {
  uint index = (gl_WorkGroupID.y * kTilesPerRow + gl_WorkGroupID.x) * kEdgeGroup + gl_LocalInvocationIndex;
  if (index >= edgeWords[3]) return;
  uint word = edgeWords[kEdgeListStart + index];
  ivec2 place = ivec2(word & 0xffffu, word >> 16);
  float most = 0.0;
  ivec2 toward = ivec2(0);
  for (int side = 0; side < 4; ++side) {
    ivec2 across = side < 2 ? ivec2(0, 2 * side - 1) : ivec2(2 * side - 5, 0);
    if (!border(place, across)) continue;
    float share = shareBeyond(place, across);
    if (share > most) {
      most = share;
      toward = across;
    }
  }
  if (most == 0.0) return;
  vec3 radiance = mix(texelFetch(shaded, place, 0).rgb, texelFetch(shaded, place + toward, 0).rgb, most);
  imageStore(outputImage, place, vec4(radiance, 1));
}
