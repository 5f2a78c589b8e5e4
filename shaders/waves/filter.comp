#version 460
#extension GL_EXT_control_flow_attributes : require
#extension GL_GOOGLE_include_directive : require
// Box-filters a tile of 32 x 32 texels of one mip into up to five coarser ones, all four maps at once.
// MAP_FORMAT and FOAM_FORMAT are defined by the build.
#include "shared/waves.h"

// Each thread makes a block of 4 x 4 texels into the first two levels by itself: a thread without a texel at some level
// costs as much as one with, on software devices.
layout(local_size_x = 64) in;

layout(set = 0, binding = 0, MAP_FORMAT) readonly uniform image2DArray displacementSource;
layout(set = 0, binding = 1, MAP_FORMAT) readonly uniform image2DArray gradientSource;
layout(set = 0, binding = 2, MAP_FORMAT) readonly uniform image2DArray momentsSource;
layout(set = 0, binding = 3, FOAM_FORMAT) readonly uniform image2DArray foamSource;
layout(set = 0, binding = 4) writeonly uniform image2DArray displacementMips[kFilterLevels];
layout(set = 0, binding = 5) writeonly uniform image2DArray gradientMips[kFilterLevels];
layout(set = 0, binding = 6) writeonly uniform image2DArray momentsMips[kFilterLevels];
layout(set = 0, binding = 7) writeonly uniform image2DArray foamMips[kFilterLevels];
layout(push_constant) uniform Push { WaveFilterPush push; };

struct Texel {
  vec4 displacement;
  vec4 gradient;
  vec4 moments;
  float foam;
};

// From the second level on, each has slots of its own, so that one barrier a level is enough.
const uint kSlots = 64 + 16 + 4;
shared vec4 displacements[kSlots];
shared vec4 gradients[kSlots];
shared vec4 moments[kSlots];
shared float foams[kSlots];

// Beyond the edge, where nothing is stored, the last texel.
Texel load(ivec3 texelPlace, bool hasFoam) {
  const ivec3 place = min(texelPlace, ivec3(push.size - 1, push.size - 1, texelPlace.z));
  Texel texel;
  texel.displacement = imageLoad(displacementSource, place);
  texel.gradient = imageLoad(gradientSource, place);
  texel.moments = imageLoad(momentsSource, place);
  texel.foam = hasFoam ? imageLoad(foamSource, place).x : 0.0;
  return texel;
}

Texel recall(uint slot) { return Texel(displacements[slot], gradients[slot], moments[slot], foams[slot]); }

void keep(uint slot, Texel texel) {
  displacements[slot] = texel.displacement;
  gradients[slot] = texel.gradient;
  moments[slot] = texel.moments;
  foams[slot] = texel.foam;
}

// Variance of dh/dx, of dh/dz, and their covariance that a child adds by its distance from the mean.
vec4 between(vec4 gradient, vec2 mean) {
  const vec2 d = gradient.xy - mean;
  return vec4(d.x * d.x, d.y * d.y, d.x * d.y, 0);
}

Texel merge(Texel a, Texel b, Texel c, Texel d) {
  Texel texel;
  texel.displacement = 0.25 * (a.displacement + b.displacement + c.displacement + d.displacement);
  texel.gradient = 0.25 * (a.gradient + b.gradient + c.gradient + d.gradient);
  const vec2 mean = texel.gradient.xy;
  texel.moments = 0.25 * (a.moments + b.moments + c.moments + d.moments + between(a.gradient, mean) +
                          between(b.gradient, mean) + between(c.gradient, mean) + between(d.gradient, mean));
  texel.foam = 0.25 * (a.foam + b.foam + c.foam + d.foam);
  return texel;
}

// The mean of the 2 x 2 texels of the source below `place`.
Texel reduced(ivec3 place, bool hasFoam) {
  const ivec3 finer = ivec3(2 * place.xy, place.z);
  return merge(load(finer, hasFoam), load(finer + ivec3(1, 0, 0), hasFoam), load(finer + ivec3(0, 1, 0), hasFoam),
               load(finer + ivec3(1, 1, 0), hasFoam));
}

// Whether the mip of a level is to be made and has this texel.
bool exists(uint level, ivec3 place) {
  return level < push.levels && max(place.x, place.y) < int(push.size >> (level + 1));
}

// A macro, because images are chosen by constants only.
#define STORE(level, place, texel)                                      \
  if (exists(level, place)) {                                           \
    imageStore(displacementMips[level], place, texel.displacement);     \
    imageStore(gradientMips[level], place, texel.gradient);             \
    imageStore(momentsMips[level], place, texel.moments);               \
    if (hasFoam) imageStore(foamMips[level], place, vec4(texel.foam));  \
  }

// Makes a level of `side` x `side` texels a tile from the slots at `source`, and keeps it at `target`.
#define REDUCE(level, side, source, target)                                                                      \
  barrier();                                                                                                     \
  if (thread < side * side) {                                                                                    \
    const uvec2 local = uvec2(thread % side, thread / side);                                                     \
    const ivec3 place = ivec3(gl_WorkGroupID.xy * side + local, gl_WorkGroupID.z);                               \
    const uint slot = source + 4 * local.y * side + 2 * local.x;                                                 \
    const Texel texel = merge(recall(slot), recall(slot + 1), recall(slot + 2 * side), recall(slot + 2 * side + 1)); \
    STORE(level, place, texel)                                                                                   \
    if (side > 1) keep(target + thread, texel);                                                                  \
  }

void main() {
  const uint thread = gl_LocalInvocationID.x;
  const bool hasFoam = gl_WorkGroupID.z < push.foamCascades;
  const ivec3 place = ivec3(gl_WorkGroupID.xy * 8 + uvec2(thread % 8, thread / 8), gl_WorkGroupID.z);
  const ivec3 finer = ivec3(2 * place.xy, place.z);
  const Texel a = reduced(finer, hasFoam);
  const Texel b = reduced(finer + ivec3(1, 0, 0), hasFoam);
  const Texel c = reduced(finer + ivec3(0, 1, 0), hasFoam);
  const Texel d = reduced(finer + ivec3(1, 1, 0), hasFoam);
  STORE(0, finer, a)
  STORE(0, finer + ivec3(1, 0, 0), b)
  STORE(0, finer + ivec3(0, 1, 0), c)
  STORE(0, finer + ivec3(1, 1, 0), d)
  const Texel texel = merge(a, b, c, d);
  STORE(1, place, texel)
  keep(thread, texel);
  REDUCE(2, 4, 0, 64)
  REDUCE(3, 2, 64, 80)
  REDUCE(4, 1, 80, 84)
}
