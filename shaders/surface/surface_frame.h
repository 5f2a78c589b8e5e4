// What one frame of one view of the sea's surface is, and the grid's fixed sizes. A uniform block for the draw, a
// storage block for compute: Mesa's software device reads uniforms faster, but compiles a shader anew for every value
// of a uniform on which its control flow depends.
#ifndef PELAGIC_SURFACE_FRAME_H
#define PELAGIC_SURFACE_FRAME_H
#include "pelagic/shader/types.h"
#include "pelagic/shader/wave_sampling.h"

PELAGIC_SHADER_BEGIN

PELAGIC_SHADER_CONSTANT uint kBlockSide = 16;               // vertices along a block's side
PELAGIC_SHADER_CONSTANT uint kBlockCells = kBlockSide - 1;  // cells along a block's side
PELAGIC_SHADER_CONSTANT uint kBlockVertices = kBlockSide * kBlockSide;
PELAGIC_SHADER_CONSTANT uint kBlockIndices = 6 * kBlockCells * kBlockCells;

// World directions, relative to the camera, everywhere [m]. The grid lies in the frame of the heading: X to the right
// of it, Z along it. Vertex (i, j) is the ground point Z = rows[j].x, X = (firstColumn + i * columnStep) * rows[j].y.
struct SurfaceFrame {
  mat4 clip;            // relative position to clip space
  mat4 previousClip;    // the same of the previous frame
  vec4 axes;            // world (x,z) of X, world (x,z) of Z
  vec4 previousOffset;  // xyz camera less previous camera [m], w radius of the planet [m]
  float firstColumn;    // [1]
  float columnStep;     // [1]
  float radius;         // ground points farther than this from the camera's foot are drawn in to it [m]
  float cameraHeight;   // [m]
  vec2 inverseExtent;   // [1/px]
  float motionScale;    // 0 in a view's first frame, then 1
  uint blocks;          // of the whole grid
  WaveSampling waves;   // relative to the camera's (x,z)
};

PELAGIC_SHADER_END

#endif
