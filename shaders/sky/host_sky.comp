#version 460
// A host's picture of the sky in the layout of the radiance map. Rows divide the way from horizon to zenith, whatever the
// eye's horizon. Below it stands the light that air of great depth has, which is that of the horizon: what is far fades into
// it.
#extension GL_GOOGLE_include_directive : require
#include "shared/sky_pass.h"

layout(local_size_x = kSkyTile, local_size_y = kSkyTile) in;
layout(push_constant) uniform Push { HostSkyPass pass; };
layout(binding = 0) uniform sampler2D picture;  // rows from the zenith to the horizon, repeats along them
layout(binding = 1) uniform writeonly image2D radiance;

// A thirtieth of a turn and of the way to the zenith, so that no mast on the horizon streaks the sea below.
const vec2 kAirSpan = vec2(0.033);
const ivec2 kAirTaps = ivec2(68, 2);  // as many as the widest picture has there

// Mean between two corners; a bilinear tap is as good as two by two pixels.
vec3 meanBetween(vec2 low, vec2 high, ivec2 most) {
  ivec2 taps = clamp(ivec2(ceil(0.5 * (high - low) * vec2(textureSize(picture, 0)))), ivec2(1), most);
  vec3 sum = vec3(0);
  for (int y = 0; y < taps.y; ++y) {
    for (int x = 0; x < taps.x; ++x) {
      sum += textureLod(picture, mix(low, high, (vec2(x, y) + 0.5) / vec2(taps)), 0).rgb;
    }
  }
  return sum / float(taps.x * taps.y);
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  vec2 size = vec2(imageSize(radiance));
  vec2 along = (vec2(texel.x) + vec2(0, 1)) / size.x - pass.turn;
  // Edges of the texel: parts of the way to the zenith, squared as in skyElevation().
  vec2 rows = (2.0 * vec2(texel.y) + vec2(0, 2)) / size.y - 1.0;
  bool air = rows.x < 0.0;
  vec2 down = air ? vec2(1.0, 1.0 - kAirSpan.y) : 1.0 - rows * rows;
  float wider = air ? max(0.5 * (kAirSpan.x - along.y + along.x), 0.0) : 0.0;
  vec3 light = meanBetween(vec2(along.x - wider, down.y), vec2(along.y + wider, down.x), air ? kAirTaps : ivec2(64));
  imageStore(radiance, texel, vec4(light, 1));
}
