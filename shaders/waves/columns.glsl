// Transforms the columns of one plane of the intermediate; neighbouring columns lie along x.
// Include after "shared/waves.h".
#ifndef PELAGIC_WAVES_COLUMNS_GLSL
#define PELAGIC_WAVES_COLUMNS_GLSL

layout(local_size_x_id = 0, local_size_y_id = 1) in;
// Rows in [kBand, N - kBand) are zero and not stored.
layout(constant_id = 2) const uint kBand = 128;

layout(set = 0, binding = 0) uniform samplerBuffer planes;
layout(set = 0, binding = 1, std430) readonly buffer Cascades { WaveCascade cascades[]; };

#define FFT_THREADS gl_WorkGroupSize.y
#define FFT_THREAD gl_LocalInvocationID.y
shared vec4 slots[16 * gl_WorkGroupSize.y * gl_WorkGroupSize.x];
#define FFT_EXCHANGE(i) slots[(i) * gl_WorkGroupSize.x + gl_LocalInvocationID.x]
#include "waves/fft.glsl"

// Of a cascade, between the sea that goes and the one that comes.
WaveCascade cascadeAt(uint cascade, float share) {
  WaveCascade mixed = cascades[cascade];
  const WaveCascade before = cascades[kMostCascades + cascade];
  mixed.heightScale = mix(before.heightScale, mixed.heightScale, share);
  mixed.foldThreshold = mix(before.foldThreshold, mixed.foldThreshold, share);
  mixed.inverseSpread = mix(before.inverseSpread, mixed.inverseSpread, share);
  return mixed;
}

// `plane` counts planes of all cascades.
void transformColumn(uint plane) {
  const int first = int(plane * kSize * kSize + gl_GlobalInvocationID.x);
#define LOAD(e)                                                                  \
  v[e] = e * FFT_THREADS < kBand || (e + 1) * FFT_THREADS > kSize - kBand         \
             ? texelFetch(planes, first + int((FFT_THREAD + e * FFT_THREADS) * kSize)) \
             : vec4(0);
  FFT_EACH(LOAD)
  transformLine();
}

#endif
