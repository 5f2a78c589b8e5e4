// One work-group lists the blocks in the picture, near to far, and writes the indirect draw.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/surface_frame.h"

layout(local_size_x = 256) in;

layout(set = 0, binding = 0, std430) readonly buffer Flags { uint flags[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Visible { uint visible[]; };
// VkDrawIndexedIndirectCommand.
layout(set = 0, binding = 2, std430) writeonly buffer Arguments { uint arguments[5]; };
layout(set = 0, binding = 3, std430) readonly buffer Frame { SurfaceFrame frame; };

shared uint sums[gl_WorkGroupSize.x];

void main() {
  uint self = gl_LocalInvocationIndex;
  uint blocks = frame.blocks;
  uint share = (blocks + gl_WorkGroupSize.x - 1) / gl_WorkGroupSize.x;
  uint first = min(self * share, blocks);
  uint last = min(first + share, blocks);
  uint count = 0;
  for (uint i = first; i < last; ++i) count += flags[i];

  // Inclusive prefix sum over the work-group.
  uint sum = count;
  for (uint step = 1; step < gl_WorkGroupSize.x; step *= 2) {
    sums[self] = sum;
    barrier();
    if (self >= step) sum += sums[self - step];
    barrier();
  }

  uint next = sum - count;
  for (uint i = first; i < last; ++i) {
    if (flags[i] != 0) visible[next++] = i;
  }
  if (self == gl_WorkGroupSize.x - 1) {
    arguments[0] = kBlockIndices;
    arguments[1] = sum;
    arguments[2] = 0;
    arguments[3] = 0;
    arguments[4] = 0;
  }
}
