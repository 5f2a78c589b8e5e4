#version 460
#extension GL_EXT_control_flow_attributes : require
#extension GL_GOOGLE_include_directive : require
// Transforms the columns and assembles the finest mip of the maps.
#include "shared/waves.h"
#include "waves/columns.glsl"
#include "physics/whitecaps.glsl"

layout(set = 0, binding = 2, std430) readonly buffer Foam { uint history[]; };
layout(set = 0, binding = 3) writeonly uniform image2DArray displacementMap;
layout(set = 0, binding = 4) writeonly uniform image2DArray gradientMap;
layout(set = 0, binding = 5) writeonly uniform image2DArray momentsMap;
layout(set = 0, binding = 6) writeonly uniform image2DArray foamMap;
layout(push_constant) uniform Push { WaveColumnsPush push; };

// a: dDx/dx, dDz/dz, dDz/dx, h; b: Dx, Dz, dh/dx, dh/dz.
void store(uint cascade, WaveCascade constants, uint row, vec4 a, vec4 b) {
  const uvec2 texel = uvec2(gl_GlobalInvocationID.x, row);
  const ivec3 place = ivec3(texel, cascade);
  const float jacobian = (1 + a.x) * (1 + a.y) - a.z * a.z;
  imageStore(displacementMap, place, vec4(b.x, a.w, b.y, jacobian));
  imageStore(gradientMap, place, vec4(b.zw, a.xy));
  imageStore(momentsMap, place, vec4(0, 0, 0, a.z));
  if (cascade < push.foamCascades) {
    const float now = breakingCoverage(jacobian, constants.foldThreshold, constants.inverseSpread);
    const float past = float(history[(cascade * kSize + texel.y) * kSize + texel.x]) / float(kFoamSteps) - push.fade;
    imageStore(foamMap, place, vec4(max(now, past), 0, 0, 0));
  }
}

void main() {
  const uint cascade = gl_WorkGroupID.z;
  const WaveCascade constants = cascadeAt(cascade, push.share);
  transformColumn(2 * cascade);
  vec4 a[16];  // dDx/dx, dDz/dz, dDz/dx, h * heightScale
#define KEEP(e) a[e] = v[e];
  FFT_EACH(KEEP)
  barrier();
  transformColumn(2 * cascade + 1);

  const float heightScale = 1 / constants.heightScale;
#define STORE(e) store(cascade, constants, FFT_THREAD + e * FFT_THREADS, a[e] * vec4(1, 1, 1, heightScale), v[e]);
  FFT_EACH(STORE)
}
