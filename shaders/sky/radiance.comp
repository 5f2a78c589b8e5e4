#version 460
// The sky over the whole horizon: clear and overcast mixed. Below the horizon a view's map holds what the air adds, that of
// sea level the radiance of the horizon at the same azimuth, so that filtering across it shows no rim.
#extension GL_GOOGLE_include_directive : require
#include "pelagic/shader/types.h"
#include "physics/atmosphere.glsl"
#include "physics/moon.glsl"
#include "pelagic/shader/sky_light.h"
#include "shared/sky_pass.h"

layout(local_size_x = kSkyTile, local_size_y = kSkyTile) in;
layout(push_constant) uniform Push { SkyPass pass; };
layout(binding = 0) uniform sampler2D clear;
layout(binding = 1, std430) readonly buffer Light { SkyLight light; };
layout(binding = 2) writeonly uniform image2D radiance;
layout(binding = 3) uniform sampler2D moonlit;  // as clear, by the moon

// Place in a map that is relative to the azimuth of its light: from that, in turns, 0 ... 0.5.
float placeFrom(float u, float azimuth) { return sqrt(2.0 * abs(fract(u - azimuth / (2.0 * kAirPi) + 0.5) - 0.5)); }

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  vec2 uv = (vec2(texel) + 0.5) / vec2(imageSize(radiance));
  float row = 2.0 * uv.y - 1.0;
  float rows = row > 0.0 ? row * float(kClearSize) : row * float(pass.airRows);
  // Not across the horizon: the two sides are different things.
  rows = row > 0.0 ? max(rows, 0.5) : min(rows, pass.airRows > 0u ? -0.5 : 0.5);
  float v = (rows + float(pass.airRows)) / float(kClearSize + pass.airRows);
  vec3 clearSky = textureLod(clear, vec2(placeFrom(uv.x, pass.sunAzimuth), v), 0).rgb +
                  kMoonTint * textureLod(moonlit, vec2(placeFrom(uv.x, pass.moonAzimuth), v), 0).rgb;
  vec3 clouds = light.cloudZenith.rgb * cieOvercast(sin(max(skyElevation(uv.y, pass.edge), 0.0)));
  imageStore(radiance, texel, vec4(clearSky * (1.0 - pass.overcast) + clouds, 1));
}
