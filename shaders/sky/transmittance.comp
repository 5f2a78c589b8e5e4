#version 460
// Transmittance from every altitude and direction to the top of the air.
#extension GL_GOOGLE_include_directive : require
#include "pelagic/shader/types.h"
#include "physics/atmosphere.glsl"
#include "shared/sky_pass.h"

layout(local_size_x = kSkyTile, local_size_y = kSkyTile) in;
layout(push_constant) uniform Push { SkyPass pass; };
layout(binding = 0) writeonly uniform image2D transmittance;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  vec2 ray = transmittanceRay(vec2(texel) / vec2(kTransmittanceWidth - 1, kTransmittanceHeight - 1));
  imageStore(transmittance, texel, vec4(exp(-airOpticalDepth(ray.x, ray.y, pass.haze, 40)), 1));
}
