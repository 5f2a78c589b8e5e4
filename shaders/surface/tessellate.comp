// One work-group is one block of the grid: places its vertices on the displaced sea and tells whether any of it can be
// seen. Neighbours evaluate their common vertices from the same numbers: no cracks.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/surface_frame.h"
#include "pelagic/shader/wave_lookup.glsl"
#include "pelagic/shader/wave_gain.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const bool kMotion = false;
layout(constant_id = 1) const bool kGain = false;

layout(set = 0, binding = 0, std430) readonly buffer Frame { SurfaceFrame frame; };
layout(set = 0, binding = 1, std430) readonly buffer Rows { vec2 rows[]; };
layout(set = 0, binding = 2) uniform sampler2DArray displacement;
layout(set = 0, binding = 3) uniform sampler2DArray previousDisplacement;
// Two per vertex: relative position, previous clip x | undisplaced (x,z), previous clip y and w; 0 without kMotion.
layout(set = 0, binding = 4, std430) writeonly buffer Vertices { vec4 vertices[]; };
// Of every block: 1 when it is in the picture.
layout(set = 0, binding = 5, std430) writeonly buffer Flags { uint flags[]; };
layout(set = 0, binding = 6) uniform sampler2DArray gainMap;

shared uint outside;  // bits of what every vertex of the block lies outside of

// Low-passed to half the grid's spacing `footprint` [m], so that the moving grid hardly shows: waves shorter than a cell
// are left to shading. Texels as long as cells would take a quarter off waves of four cells.
vec3 displaced(sampler2DArray map, vec2 p, float footprint) {
  vec3 sum = vec3(0);
  vec2 q = p + waveWarp(frame.waves.warp, p);
  uint c = 0;
  do {  // there is at least one, and software devices run a body that a loop's head has masked out
    vec4 placement = frame.waves.placement[c];
    float lod = waveLod(placement, float(frame.waves.size), 0.5 * footprint);
    // The last mip is the patch's mean, which is zero.
    float gain = kGain ? waveGain(gainMap, frame.waves.gain, p, c) : 1.0;
    if (lod < frame.waves.maxLod) sum += gain * textureLod(map, vec3(waveUv(placement, q), float(c)), lod).xyz;
  } while (++c < frame.waves.cascades);
  return sum;
}

// How far the sea level lies below the tangent plane at the place `ground` [m], without cancellation.
float curvatureDrop(vec2 ground) {
  float radius = frame.previousOffset.w;
  float r2 = dot(ground, ground);
  return r2 / (radius + sqrt(max(radius * radius - r2, 0.0)));
}

// The longer side of the cells around a row [m].
float cellLength(uint j, float lateral) {
  uint before = j > 0 ? j - 1 : 0;
  uint after = min(j + 1, gl_NumWorkGroups.y * kBlockCells);
  return max(lateral, (rows[after].x - rows[before].x) / float(after - before));
}

// Bits 0 to 3: beyond a side of the picture by more than rounding, bit 4: drawn in to the far circle.
uint outcode(vec4 clip, bool drawnIn) {
  bvec4 beyond = lessThan(vec4(clip.w) + vec4(clip.x, -clip.x, clip.y, -clip.y), vec4(-1e-4 * abs(clip.w)));
  return uint(beyond.x) | uint(beyond.y) << 1 | uint(beyond.z) << 2 | uint(beyond.w) << 3 | uint(drawnIn) << 4;
}

vec4 previousClip(vec2 ground, float footprint) {
  vec2 previousGround = ground + frame.previousOffset.xz;
  float level = frame.previousOffset.y - frame.cameraHeight - curvatureDrop(previousGround);
  vec3 before = vec3(previousGround.x, level, previousGround.y) + displaced(previousDisplacement, ground, footprint);
  return frame.previousClip * vec4(before, 1);
}

void main() {
  uvec2 index = gl_WorkGroupID.xy * kBlockCells + gl_LocalInvocationID.xy;
  vec2 row = rows[index.y];
  vec2 local = vec2((frame.firstColumn + float(index.x) * frame.columnStep) * row.y, row.x);
  float range = length(local);
  bool drawnIn = range >= frame.radius;
  if (drawnIn) local *= frame.radius / range;
  vec2 ground = local.x * frame.axes.xy + local.y * frame.axes.zw;

  float footprint = cellLength(index.y, frame.columnStep * row.y);
  vec3 position = vec3(ground.x, -curvatureDrop(ground) - frame.cameraHeight, ground.y) +
                  displaced(displacement, ground, footprint);

  if (gl_LocalInvocationIndex == 0) outside = ~0u;
  barrier();
  atomicAnd(outside, outcode(frame.clip * vec4(position, 1), drawnIn));
  barrier();
  uint block = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  if (gl_LocalInvocationIndex == 0) flags[block] = uint(outside == 0);
  if (outside == 0) {
    vec4 previous = kMotion ? previousClip(ground, footprint) : vec4(0);
    uint base = 2 * (block * kBlockVertices + gl_LocalInvocationIndex);
    vertices[base] = vec4(position, previous.x);
    vertices[base + 1] = vec4(ground, previous.yw);
  }
}
