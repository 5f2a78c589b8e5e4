#version 460
#extension GL_EXT_control_flow_attributes : require
#extension GL_GOOGLE_include_directive : require
// The surface vertically over or under points.
#include "shared/query.h"
#include "pelagic/shader/wave_sampling.h"
#include "waves/query.glsl"

void main() {
  const uint item = gl_GlobalInvocationID.x;
  if (item >= push.count) return;
  load(item);
  storeSurface(item, vec2(0), true);
}
