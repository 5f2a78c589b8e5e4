// Fetches the vertices that tessellate.comp placed: one instance is one block. The build defines MOTION for views that
// leave motion vectors.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/surface_frame.h"

layout(set = 0, binding = 0, std140) uniform Frame { SurfaceFrame frame; };
layout(set = 0, binding = 1, std430) readonly buffer Vertices { vec4 vertices[]; };
layout(set = 0, binding = 2, std430) readonly buffer Visible { uint visible[]; };

layout(location = 0) out vec2 outGround;
#ifdef MOTION
layout(location = 1) out vec3 outPrevious;
#endif

void main() {
  uint base = 2 * (visible[gl_InstanceIndex] * kBlockVertices + uint(gl_VertexIndex));
  vec4 a = vertices[base];
  vec4 b = vertices[base + 1];
  gl_Position = frame.clip * vec4(a.xyz, 1);
  outGround = b.xy;
#ifdef MOTION
  outPrevious = vec3(a.w, b.zw);
#endif
}
