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

vec2 h[16];
float chop[16];

// Phase of `cycles` turns per loop [rad], from the high word of cycles x fraction.
float phase(uint cycles) {
  uint high, low;
  umulExtended(cycles, push.fractionLow, high, low);
  return float(int(cycles * push.fractionHigh + high)) * (kTwoPi / 4294967296.0);
}

// Whether samples e N/16 ... (e + 1) N/16 of a line are not all zero.
bool inBand(uint e) { return e * FFT_THREADS < kBand || (e + 1) * FFT_THREADS > kSize - kBand; }

void main() {
  const uint cascade = gl_WorkGroupID.z;
  uint row = gl_GlobalInvocationID.y;
  if (row >= kBand) row += kSize - 2 * kBand;
  const float step = cascades[cascade].waveNumberStep;
  const float heightScale = cascades[cascade].heightScale;
  const float kz = step * float(row < kSize / 2 ? int(row) : int(row) - int(kSize));
  const int line = int((cascade * kSize + row) * kSize);

  [[unroll]] for (uint e = 0; e < 16; ++e) {
    h[e] = vec2(0);
    chop[e] = 0;
    v[e] = vec4(0);
    if (!inBand(e)) continue;
    const uint column = FFT_THREAD + e * FFT_THREADS;
    const float kx = step * float(e < 8 ? int(column) : int(column) - int(kSize));
    const vec4 amplitude = texelFetch(amplitudes, line + int(column));
    const uvec2 mode = texelFetch(modes, line + int(column)).xy;
    const vec2 w = unit(phase(mode.x));
    // h0(k) e^{-i w t} + conj h0(-k) e^{+i w t}
    h[e] = vec2((amplitude.x + amplitude.z) * w.x + (amplitude.y - amplitude.w) * w.y,
                (amplitude.y + amplitude.w) * w.x + (amplitude.z - amplitude.x) * w.y);
    chop[e] = uintBitsToFloat(mode.y);
    // D = i k chop h, so dDx/dx = -kx^2 chop h and so on.
    const vec3 stretch = -chop[e] * vec3(kx * kx, kz * kz, kx * kz);
    v[e] = vec4(stretch.x * h[e].x - stretch.y * h[e].y, stretch.x * h[e].y + stretch.y * h[e].x,
                stretch.z * h[e].x - heightScale * h[e].y, stretch.z * h[e].y + heightScale * h[e].x);
  }
  transformLine();
  const uint target = ((cascade * kPlanes) * kSize + row) * kSize + FFT_THREAD;
  [[unroll]] for (uint e = 0; e < 16; ++e) planes[target + e * FFT_THREADS] = v[e];

  if (kPlanes == 2) {
    barrier();
    [[unroll]] for (uint e = 0; e < 16; ++e) {
      const uint column = FFT_THREAD + e * FFT_THREADS;
      const float kx = step * float(e < 8 ? int(column) : int(column) - int(kSize));
      // i (kx + i kz) h
      const vec2 gradient = vec2(-kz * h[e].x - kx * h[e].y, kx * h[e].x - kz * h[e].y);
      v[e] = vec4(chop[e] * gradient, gradient);
    }
    transformLine();
    [[unroll]] for (uint e = 0; e < 16; ++e) planes[target + kSize * kSize + e * FFT_THREADS] = v[e];
  }
}
