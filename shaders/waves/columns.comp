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

void main() {
  const uint cascade = gl_WorkGroupID.z;
  const WaveCascade constants = cascades[cascade];
  transformColumn(2 * cascade);
  vec4 a[16];  // dDx/dx, dDz/dz, dDz/dx, h * heightScale
  [[unroll]] for (uint e = 0; e < 16; ++e) a[e] = v[e];
  barrier();
  transformColumn(2 * cascade + 1);  // Dx, Dz, dh/dx, dh/dz

  const float heightScale = 1 / constants.heightScale;
  [[unroll]] for (uint e = 0; e < 16; ++e) {
    const uvec2 texel = uvec2(gl_GlobalInvocationID.x, FFT_THREAD + e * FFT_THREADS);
    const ivec3 place = ivec3(texel, cascade);
    const float jacobian = (1 + a[e].x) * (1 + a[e].y) - a[e].z * a[e].z;
    imageStore(displacementMap, place, vec4(v[e].x, a[e].w * heightScale, v[e].y, jacobian));
    imageStore(gradientMap, place, vec4(v[e].zw, a[e].xy));
    imageStore(momentsMap, place, vec4(0, 0, 0, a[e].z));
    if (cascade < push.foamCascades) {
      const float now = breakingCoverage(jacobian, constants.foldThreshold, constants.inverseSpread);
      const float past = float(history[(cascade * kSize + texel.y) * kSize + texel.x]) / float(kFoamSteps) - push.fade;
      imageStore(foamMap, place, vec4(max(now, past), 0, 0, 0));
    }
  }
}
