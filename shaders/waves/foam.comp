#version 460
#extension GL_EXT_control_flow_attributes : require
#extension GL_GOOGLE_include_directive : require
// One tick of the foam's clock: what breaks now, and what broke before, one step fainter. In whole steps, so that the
// history is exact and forgets everything after kFoamSteps ticks.
#include "shared/waves.h"
#include "waves/columns.glsl"
#include "physics/whitecaps.glsl"

layout(set = 0, binding = 2, std430) readonly buffer Before { uint before[]; };
layout(set = 0, binding = 3, std430) writeonly buffer After { uint after[]; };
layout(push_constant) uniform Push { WaveFoamPush push; };

void tick(uint cascade, WaveCascade constants, uint row, vec4 a) {
  const uint texel = (cascade * kSize + row) * kSize + gl_GlobalInvocationID.x;
  const float jacobian = (1 + a.x) * (1 + a.y) - a.z * a.z;
  const float coverage = breakingCoverage(jacobian, constants.foldThreshold, constants.inverseSpread);
  const uint now = uint(coverage * float(kFoamSteps) + 0.5);
  const uint past = before[texel] * push.keep;
  after[texel] = max(now, max(past, 1u) - 1u);
}

void main() {
  const uint cascade = gl_WorkGroupID.z;
  const WaveCascade constants = cascadeAt(cascade, push.share);
  transformColumn(cascade);
#define TICK(e) tick(cascade, constants, FFT_THREAD + e * FFT_THREADS, v[e]);
  FFT_EACH(TICK)
}
