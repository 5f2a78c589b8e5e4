#version 460
#extension GL_EXT_control_flow_attributes : require
#extension GL_GOOGLE_include_directive : require
// Evolves the modes to the time asked for and transforms the rows.
// Plane A holds (dDx/dx + i dDz/dz, dDz/dx + i h), plane B (Dx + i Dz, dh/dx + i dh/dz), where i joins two real fields.
#include "shared/waves.h"

layout(local_size_x_id = 0, local_size_y_id = 1) in;
// Modes with an index in [kBand, N - kBand) along either axis are zero: neither evolved nor written.
layout(constant_id = 2) const uint kBand = 128;
layout(constant_id = 3) const uint kPlanes = 2;

layout(set = 0, binding = 0) uniform samplerBuffer amplitudes;
layout(set = 0, binding = 1) uniform usamplerBuffer modes;
layout(set = 0, binding = 2, std430) readonly buffer Cascades { WaveCascade cascades[]; };
layout(set = 0, binding = 3, std430) writeonly buffer Planes { vec4 planes[]; };
layout(push_constant) uniform Push { WaveRowsPush push; };

#define FFT_THREADS gl_WorkGroupSize.x
#define FFT_THREAD gl_LocalInvocationID.x
// One slot in 17 stays empty, so that the strides of the exchange do not meet in one memory bank.
const uint kStride = gl_WorkGroupSize.x * 17;
shared vec4 slots[kStride * gl_WorkGroupSize.y];
#define FFT_EXCHANGE(i) slots[gl_LocalInvocationID.y * kStride + (i) + (i) / 16]
#include "waves/fft.glsl"

// Phase of `cycles` turns per loop [rad], from the high word of cycles x fraction.
float phase(uint cycles) {
  uint high, low;
  umulExtended(cycles, push.fractionLow, high, low);
  return float(int(cycles * push.fractionHigh + high)) * (kTwoPi / 4294967296.0);
}

// Whether samples e N/16 ... (e + 1) N/16 of a line are not all zero.
bool inBand(uint e) { return e * FFT_THREADS < kBand || (e + 1) * FFT_THREADS > kSize - kBand; }

// Signed wave number along x of the sample e N/16 + this thread's.
float waveNumber(uint e, float step) {
  const uint column = FFT_THREAD + e * FFT_THREADS;
  return step * float(e < 8 ? int(column) : int(column) - int(kSize));
}

// h(k) = h0(k) e^{-i w t} + conj h0(-k) e^{+i w t}, and chop
vec3 evolved(int mode) {
  const vec4 amplitude = texelFetch(amplitudes, mode);
  const uvec2 constants = texelFetch(modes, mode).xy;
  const vec2 w = unit(phase(constants.x));
  return vec3((amplitude.x + amplitude.z) * w.x + (amplitude.y - amplitude.w) * w.y,
              (amplitude.y + amplitude.w) * w.x + (amplitude.z - amplitude.x) * w.y, uintBitsToFloat(constants.y));
}

// D = i k chop h, so dDx/dx = -kx^2 chop h and so on. h: real and imaginary part, chop.
vec4 planeA(float kx, float kz, vec3 h, float heightScale) {
  const vec3 stretch = -h.z * vec3(kx * kx, kz * kz, kx * kz);
  return vec4(stretch.x * h.x - stretch.y * h.y, stretch.x * h.y + stretch.y * h.x,
              stretch.z * h.x - heightScale * h.y, stretch.z * h.y + heightScale * h.x);
}

vec4 planeB(float kx, float kz, vec3 h) {
  const vec2 gradient = vec2(-kz * h.x - kx * h.y, kx * h.x - kz * h.y);  // i (kx + i kz) h
  return vec4(h.z * gradient, gradient);
}

void main() {
  const uint cascade = gl_WorkGroupID.z;
  uint row = gl_GlobalInvocationID.y;
  if (row >= kBand) row += kSize - 2 * kBand;
  const float step = cascades[cascade].waveNumberStep;
  const float heightScale = cascades[cascade].heightScale;
  const float kz = step * float(row < kSize / 2 ? int(row) : int(row) - int(kSize));
  const int line = int((cascade * kSize + row) * kSize + FFT_THREAD);
  const uint target = (cascade * kPlanes * kSize + row) * kSize + FFT_THREAD;

  vec3 h[16];
#define EVOLVE(e)                                                            \
  h[e] = inBand(e) ? evolved(line + int(e * FFT_THREADS)) : vec3(0);         \
  v[e] = inBand(e) ? planeA(waveNumber(e, step), kz, h[e], heightScale) : vec4(0);
  FFT_EACH(EVOLVE)
  transformLine();
#define STORE_A(e) planes[target + e * FFT_THREADS] = v[e];
  FFT_EACH(STORE_A)

  if (kPlanes == 2) {
    barrier();
#define TURN_TO_B(e) v[e] = inBand(e) ? planeB(waveNumber(e, step), kz, h[e]) : vec4(0);
    FFT_EACH(TURN_TO_B)
    transformLine();
#define STORE_B(e) planes[target + kSize * kSize + e * FFT_THREADS] = v[e];
    FFT_EACH(STORE_B)
  }
}
