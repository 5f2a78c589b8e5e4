#version 460
// The clouds that a camera sees, at a part of its resolution.
#extension GL_GOOGLE_include_directive : require
#include "pelagic/shader/sky_light.h"
#include "shared/sky_pass.h"

layout(local_size_x = kSkyTile, local_size_y = kSkyTile) in;
layout(push_constant) uniform Push { CloudView view; };
layout(binding = 0) uniform sampler3D volume;
layout(binding = 1) uniform sampler3D detail;
layout(binding = 2) uniform sampler2D radiance;  // the view's
layout(binding = 3, std140) uniform Light { SkyLight light; };
layout(binding = 4) uniform writeonly image2D clouds;
#include "shared/cloud_march.glsl"

// Twice as long combs the clouds' edges.
const int kSteps = 256;
const float kFinest = 22.0;  // [m]
const float kFarther = 0.01;

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= view.width || pixel.y >= view.height) return;
  vec3 d = normalize(view.ray.xyz + float(pixel.x) * view.rayX.xyz + float(pixel.y) * view.rayY.xyz);
  float side = length(d.xz), edge = view.edge * side;
  // A pixel of the clouds' picture also serves the pixels of the sky that it hangs over the horizon with.
  float pixelSize = length(view.rayY.xyz) / length(view.ray.xyz);
  if (view.ray.w < view.rayX.w && d.y > edge - 2.0 * pixelSize) d = normalize(vec3(d.x, max(d.y, edge + 1e-3), d.z));
  CloudsSeen seen = cloudsAlong(volume, detail, d, view.ray.w, view.place, view.rayX.w, view.rayY.w, view.openSea, kFinest,
                                kFarther, pixelSize, kSteps);
  vec3 shown = vec3(0);
  // Once where there are clouds. A loop, because software devices walk through both sides of a branch.
  for (float cover = 1.0 - seen.transmittance; cover > 0.0; cover = 0.0) {
    float row = skyRow(asin(clamp(d.y, -1.0, 1.0)), view.edge);
    float azimuth = dot(d.xz, d.xz) > 0.0 ? atan(d.z, d.x) : 0.0;  // none straight up and down
    vec3 air = textureLod(radiance, vec2(azimuth / (2.0 * kAirPi), row), 0).rgb;
    shown = cloudsThroughAir(seen, view.ray.w, view.rayX.w, view.rayY.w, air);
  }
  imageStore(clouds, ivec2(pixel), vec4(shown, seen.transmittance));
}
