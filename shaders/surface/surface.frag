// Leaves the thin water buffer; all shading is done per pixel in compute. The build defines MOTION for views that leave
// motion vectors.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/surface_frame.h"

layout(location = 0) in vec2 ground;
layout(location = 0) out vec2 outPosition;
layout(location = 1) out uint outBody;

#ifdef MOTION
layout(set = 0, binding = 0, std140) uniform Frame { SurfaceFrame frame; };
layout(location = 1) in vec3 previous;  // clip x, y, w of the previous frame
layout(location = 2) out vec2 outMotion;
#endif

void main() {
  outPosition = ground;
  outBody = 1;
#ifdef MOTION
  // A point that was behind the camera has no place on the previous picture: the bound keeps the motion finite.
  vec2 before = 0.5 * previous.xy / max(previous.z, 1e-6) + 0.5;
  outMotion = frame.motionScale * clamp(gl_FragCoord.xy * frame.inverseExtent - before, -16.0, 16.0);
#endif
}
