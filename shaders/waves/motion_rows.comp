#version 460
#extension GL_EXT_control_flow_attributes : require
#extension GL_GOOGLE_include_directive : require
// Evolves the first two derivatives in time of the displacement and transforms their rows.
// Plane 2 c holds d/dt of (Dx + i Dz, h) of cascade c, plane 2 c + 1 the second derivative; h keeps a complex number of
// its own, because velocities and accelerations of short waves differ too much in size to share one.
#include "shared/waves.h"
#include "shared/query.h"

layout(push_constant) uniform Push { WaveMotionPush push; };
#include "waves/rows.glsl"

// weights.x h + weights.y dh/dt + weights.z d2h/dt2 of a mode of one sea in xy, chop times that in zw.
vec4 changeOfOne(int mode, vec3 weights) {
  const vec4 a = texelFetch(amplitudes, mode);
  const uvec3 constants = texelFetch(modes, mode).xyz;
  const vec2 w = unit(phase(constants.x));
  const vec2 forward = vec2(a.x * w.x + a.y * w.y, a.y * w.x - a.x * w.y);   // h0(k) e^{-i w t}
  const vec2 backward = vec2(a.z * w.x - a.w * w.y, a.w * w.x + a.z * w.y);  // conj h0(-k) e^{+i w t}
  const float frequency = push.radiansPerCycle * float(constants.x);
  const vec2 h = forward + backward;
  const vec2 apart = backward - forward;
  const vec2 rate = frequency * vec2(-apart.y, apart.x);  // -i w forward + i w backward
  const vec2 sum = (weights.x - weights.z * frequency * frequency) * h + weights.y * rate;
  return vec4(sum, times(uintBitsToFloat(constants.yz), sum));
}

// d/dt or d2/dt2 of share times h.
vec3 weightsOf(uint order, vec3 share) {
  return order == 0 ? vec3(share.y, share.x, 0) : vec3(share.z, 2 * share.y, share.x);
}

vec4 changeOf(int mode, uint order) {
  const vec3 share = vec3(push.share, push.shareRate, push.shareAcceleration);
  vec4 sum = changeOfOne(mode, weightsOf(order, share));
  if (kChanging) {
    sum += changeOfOne(mode + textureSize(modes) / 2, weightsOf(order, vec3(1 - share.x, -share.yz)));
  }
  return sum;
}

void main() {
  const uint plane = gl_WorkGroupID.z;
  const uint cascade = plane / 2;
  const uint order = plane % 2;
  const uint row = rowOfInvocation();
  const float step = cascades[cascade].waveNumberStep;
  const float kz = waveNumber(row, step);
  const int line = int((cascade * kSize + row) * kSize + FFT_THREAD);
  const uint target = (plane * kSize + row) * kSize + FFT_THREAD;

  // Dx + i Dz = i (kx + i kz) chop h
#define EVOLVE(e)                                                                                \
  {                                                                                              \
    const vec4 h = inBand(e) ? changeOf(line + int(e * FFT_THREADS), order) : vec4(0);           \
    v[e] = vec4(times(h.zw, vec2(-kz, waveNumber(FFT_THREAD + e * FFT_THREADS, step))), h.xy);   \
  }
  FFT_EACH(EVOLVE)
  transformLine();
#define STORE(e) planes[target + e * FFT_THREADS] = v[e];
  FFT_EACH(STORE)
}
