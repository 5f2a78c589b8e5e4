#version 460
#extension GL_EXT_control_flow_attributes : require
#extension GL_GOOGLE_include_directive : require
// Transforms the columns of the motion: texels of (Dx, Dz, h, 0), differentiated once in time in plane 2 c of cascade c,
// twice in plane 2 c + 1.
#include "shared/waves.h"
#include "waves/columns.glsl"

layout(set = 0, binding = 2, std430) writeonly buffer Motion { vec4 motion[]; };

void main() {
  const uint plane = gl_WorkGroupID.z;
  transformColumn(plane);
  const uint target = (plane * kSize + FFT_THREAD) * kSize + gl_GlobalInvocationID.x;
#define STORE(e) motion[target + e * FFT_THREADS * kSize] = v[e];
  FFT_EACH(STORE)
}
