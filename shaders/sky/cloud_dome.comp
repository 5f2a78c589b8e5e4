#version 460
// The clouds over the sea around the eye, as a stereographic disc like the environment's: what the water mirrors.
#extension GL_GOOGLE_include_directive : require
#include "pelagic/shader/sky_light.h"
#include "shared/sky_pass.h"

layout(local_size_x = kSkyTile, local_size_y = kSkyTile) in;
layout(push_constant) uniform Push { CloudView view; };
layout(binding = 0) uniform sampler3D volume;
layout(binding = 1) uniform sampler3D detail;
layout(binding = 2) uniform sampler2D radiance;  // of sea level
layout(binding = 3, std140) uniform Light { SkyLight light; };
layout(binding = 4) uniform writeonly image2D dome;
#include "shared/cloud_march.glsl"

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  vec2 q = ((vec2(texel) + 0.5) / float(kDomeSize) * 2.0 - 1.0) / kEnvironmentScale;
  q *= min(1.0, 0.999 * inversesqrt(max(dot(q, q), 1e-8)));  // below the horizon: the horizon
  vec3 d = vec3(2.0 * q.x, 1.0 - dot(q, q), 2.0 * q.y) / (1.0 + dot(q, q));
  vec3 air = textureLod(radiance, skyUv(d), 0).rgb;
  CloudsSeen seen = cloudsAlong(volume, detail, d, 0.0, view.place, view.rayX.w, view.rayY.w, view.openSea,
                               100.0, 0.02, 0.02, 32);
  imageStore(dome, texel, vec4(cloudsThroughAir(seen, 0.0, view.rayX.w, view.rayY.w, air), seen.transmittance));
}
