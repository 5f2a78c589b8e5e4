#version 460
// The sky's hemisphere as a disc (stereographic), premultiplied with its coverage.
#extension GL_GOOGLE_include_directive : require
#include "pelagic/shader/types.h"
#include "physics/atmosphere.glsl"
#include "pelagic/shader/sky_light.h"
#include "shared/sky_pass.h"

layout(local_size_x = kSkyTile, local_size_y = kSkyTile) in;
layout(binding = 0) uniform sampler2D radiance;
layout(binding = 1) writeonly uniform image2D environment;
layout(binding = 2) uniform sampler2D dome;  // clouds, cloud_dome.comp
layout(constant_id = 0) const bool kClouds = false;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  const float size = float(kEnvironmentSize);
  vec2 p = (vec2(texel) + 0.5) / size * 2.0 - 1.0;
  // Distance inside the horizon's circle in texels: its edge is one texel soft.
  float coverage = clamp((kEnvironmentScale - length(p)) * (0.5 * size) + 0.5, 0.0, 1.0);
  vec2 q = p / kEnvironmentScale;
  vec3 direction = vec3(2.0 * q.x, 1.0 - dot(q, q), 2.0 * q.y) / (1.0 + dot(q, q));
  vec3 light = textureLod(radiance, skyUv(direction), 0).rgb;
  if (kClouds) {
    vec4 clouds = textureLod(dome, (vec2(texel) + 0.5) / size, 0);
    light = light * clouds.a + clouds.rgb;
  }
  imageStore(environment, texel, vec4(light, 1) * coverage);
}
