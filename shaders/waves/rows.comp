#version 460
#extension GL_EXT_control_flow_attributes : require
#extension GL_GOOGLE_include_directive : require
// Evolves the modes to the time asked for and transforms the rows.
// Plane A holds (dDx/dx + i dDz/dz, dDz/dx + i h), plane B (Dx + i Dz, dh/dx + i dh/dz), where i joins two real fields.
#include "shared/waves.h"

layout(constant_id = 3) const uint kPlanes = 2;

layout(push_constant) uniform Push { WaveRowsPush push; };
#include "waves/rows.glsl"

// D = i k chop h, so dDx/dx = -kx^2 chop h and so on. h: elevation in xy, chop times it in zw.
vec4 planeA(float kx, float kz, vec4 h, float heightScale) {
  const vec3 stretch = -vec3(kx * kx, kz * kz, kx * kz);
  return vec4(stretch.x * h.z - stretch.y * h.w, stretch.x * h.w + stretch.y * h.z,
              stretch.z * h.z - heightScale * h.y, stretch.z * h.w + heightScale * h.x);
}

vec4 planeB(float kx, float kz, vec4 h) { return turned(h.zwxy, vec2(-kz, kx)); }  // i (kx + i kz)

void main() {
  const uint cascade = gl_WorkGroupID.z;
  const uint row = rowOfInvocation();
  const float step = cascades[cascade].waveNumberStep;
  const float heightScale = mix(cascades[kMostCascades + cascade].heightScale, cascades[cascade].heightScale, push.share);
  const float kz = waveNumber(row, step);
  const int line = int((cascade * kSize + row) * kSize + FFT_THREAD);
  const uint target = (cascade * kPlanes * kSize + row) * kSize + FFT_THREAD;

  vec4 h[16];
#define KX(e) waveNumber(FFT_THREAD + e * FFT_THREADS, step)
#define EVOLVE(e)                                                    \
  h[e] = inBand(e) ? evolved(line + int(e * FFT_THREADS)) : vec4(0); \
  v[e] = inBand(e) ? planeA(KX(e), kz, h[e], heightScale) : vec4(0);
  FFT_EACH(EVOLVE)
  transformLine();
#define STORE_A(e) planes[target + e * FFT_THREADS] = v[e];
  FFT_EACH(STORE_A)

  if (kPlanes == 2) {
    barrier();
#define TURN_TO_B(e) v[e] = inBand(e) ? planeB(KX(e), kz, h[e]) : vec4(0);
    FFT_EACH(TURN_TO_B)
    transformLine();
#define STORE_B(e) planes[target + kSize * kSize + e * FFT_THREADS] = v[e];
    FFT_EACH(STORE_B)
  }
}
