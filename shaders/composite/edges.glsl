// Where the surface seen breaks off between one pixel and the next: at the outline of a wave, before the sky or before water
// farther off. The passes that shade leave it in alpha of a picture of such pixels, which else is 0, and the last pass smooths
// the stairs along it.
#ifndef PELAGIC_COMPOSITE_EDGES_GLSL
#define PELAGIC_COMPOSITE_EDGES_GLSL
#include "composite/bindings.glsl"

layout(binding = 19) uniform writeonly image2D shadedImage;
layout(binding = 20, std430) writeonly buffer Edges { uint edgeWords[]; };

// Inverse axial distance of the water in a pixel [1/m], which is linear in the picture on a plane; kNoWater or kHostSeen.
const float kNoWater = -1.0;
const float kHostSeen = -2.0;

float inverseDistance(ivec2 place) {
  place = clamp(place, ivec2(0), ivec2(frame.width - 1u, frame.height - 1u));
  float depth = texelFetch(waterDepth, place, 0).x;
  if (kHasHost && (texelFetch(hostDepth, place, 0).x - depth) * frame.nearer > 0.0) return kHostSeen;
  return depth == frame.rayY.w ? kNoWater : (depth - frame.rayX.w) / frame.ray.w;
}

// Of four pixels in a line, whether the middle two show different things.
bool breaksOff(float before, float a, float b, float after) {
  if (a == kHostSeen || b == kHostSeen) return false;  // the host smooths its own edges
  if (a < 0.0 || b < 0.0) return a != b;
  // A slope that goes on as steeply on one of the sides is one surface. A hundredth: what half a pixel of a wave's face hides.
  float around = max(before < 0.0 ? 0.0 : abs(a - before), after < 0.0 ? 0.0 : abs(after - b));
  return abs(b - a) > 3.0 * around + 0.01 * max(a, b);
}

uint edgesOf(ivec2 place) {
  const ivec2 x = ivec2(1, 0), y = ivec2(0, 1);
  float here = inverseDistance(place);
  float left = inverseDistance(place - x), right = inverseDistance(place + x);
  float above = inverseDistance(place - y), below = inverseDistance(place + y);
  uint edges = 0u;
  if (breaksOff(right, here, left, inverseDistance(place - 2 * x))) edges |= kEdgeLeft;
  if (breaksOff(left, here, right, inverseDistance(place + 2 * x))) edges |= kEdgeRight;
  if (breaksOff(below, here, above, inverseDistance(place - 2 * y))) edges |= kEdgeAbove;
  if (breaksOff(above, here, below, inverseDistance(place + 2 * y))) edges |= kEdgeBelow;
  return edges;
}

// The shaded pixel, for the host and for its neighbours' edges.
void writeRadiance(ivec2 place, vec3 radiance) {
  vec3 stored = clamp(radiance, vec3(0), vec3(kLargestRadiance));
  uint edges = edgesOf(place);
  imageStore(outputImage, place, vec4(stored, 1));
  if (edges != 0u) {
    imageStore(shadedImage, place, vec4(stored, float(edges)));
    uint index = atomicAdd(edgeWords[3], 1u);
    uint group = index / kEdgeGroup;
    atomicMax(edgeWords[0], min(group + 1u, kTilesPerRow));
    atomicMax(edgeWords[1], group / kTilesPerRow + 1u);
    edgeWords[kEdgeListStart + index] = uint(place.x) | uint(place.y) << 16;
  }
}

#endif
