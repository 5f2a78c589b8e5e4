// Transforms the rows of a plane of modes that were evolved. Include after "shared/waves.h" and the push constants, which
// evolve.glsl reads.
#ifndef PELAGIC_WAVES_ROWS_GLSL
#define PELAGIC_WAVES_ROWS_GLSL

layout(local_size_x_id = 0, local_size_y_id = 1) in;

layout(set = 0, binding = 2, std430) readonly buffer Cascades { WaveCascade cascades[]; };
layout(set = 0, binding = 3, std430) writeonly buffer Planes { vec4 planes[]; };

#define FFT_THREADS gl_WorkGroupSize.x
#define FFT_THREAD gl_LocalInvocationID.x
// One slot in 17 stays empty, so that the strides of the exchange do not meet in one memory bank.
const uint kStride = gl_WorkGroupSize.x * 17;
shared vec4 slots[kStride * gl_WorkGroupSize.y];
#define FFT_EXCHANGE(i) slots[gl_LocalInvocationID.y * kStride + (i) + (i) / 16]
#include "waves/fft.glsl"
#include "waves/evolve.glsl"

// Rows are dispatched without those that are zero.
uint rowOfInvocation() {
  const uint row = gl_GlobalInvocationID.y;
  return row < kBand ? row : row + kSize - 2 * kBand;
}

#endif
