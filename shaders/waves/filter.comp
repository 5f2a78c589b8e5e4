#version 460
#extension GL_EXT_control_flow_attributes : require
#extension GL_GOOGLE_include_directive : require
// Box-filters a tile of 32 x 32 texels of one mip into up to five coarser ones, all four maps at once.
// MAP_FORMAT and FOAM_FORMAT are defined by the build.
#include "shared/waves.h"

layout(local_size_x = 256) in;

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

// Every level has slots of its own, so that one barrier a level is enough.
const uint kSlots = 256 + 64 + 16 + 4;
shared vec4 displacements[kSlots];
shared vec4 gradients[kSlots];
shared vec4 moments[kSlots];
shared float foams[kSlots];

Texel load(ivec3 place, bool hasFoam) {
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

void main() {
  const uint thread = gl_LocalInvocationID.x;
  const uint layer = gl_WorkGroupID.z;
  const bool hasFoam = layer < push.foamCascades;
  uint source = 0;  // first slot of the level before
  uint target = 0;
  [[unroll]] for (uint level = 0; level < kFilterLevels; ++level) {
    const uint side = 16 >> level;  // of the tile at this level
    const uvec2 local = uvec2(thread % side, thread / side);
    const uvec2 texel = gl_WorkGroupID.xy * side + local;
    const bool inside = local.y < side && max(texel.x, texel.y) < push.size >> (level + 1) && level < push.levels;
    if (inside) {
      Texel merged;
      if (level == 0) {
        const ivec3 place = ivec3(2 * texel, layer);
        merged = merge(load(place, hasFoam), load(place + ivec3(1, 0, 0), hasFoam), load(place + ivec3(0, 1, 0), hasFoam),
                       load(place + ivec3(1, 1, 0), hasFoam));
      } else {
        const uint slot = source + 2 * local.y * 2 * side + 2 * local.x;
        merged = merge(recall(slot), recall(slot + 1), recall(slot + 2 * side), recall(slot + 2 * side + 1));
      }
      const ivec3 place = ivec3(texel, layer);
      imageStore(displacementMips[level], place, merged.displacement);
      imageStore(gradientMips[level], place, merged.gradient);
      imageStore(momentsMips[level], place, merged.moments);
      if (hasFoam) imageStore(foamMips[level], place, vec4(merged.foam));
      if (level + 1 < kFilterLevels) keep(target + thread, merged);
    }
    barrier();
    source = target;
    target += side * side;
  }
}
