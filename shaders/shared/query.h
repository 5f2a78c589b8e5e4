// How points on the sea are found, the same on CPU and GPU, and what the shaders that do it are told and tell.
#ifndef PELAGIC_SHARED_QUERY_H
#define PELAGIC_SHARED_QUERY_H
#include "pelagic/shader/types.h"

PELAGIC_SHADER_BEGIN

// Newton's iteration takes this many steps at most, and ends with the step from a point that misses by less than
// kLeastMiss [m], after which what is left is far smaller: the surface is linear between texels but for a bilinear
// term.
PELAGIC_SHADER_CONSTANT uint kNewtonSteps = 16u;
PELAGIC_SHADER_CONSTANT float kLeastMiss = 1e-4f;
// The least determinant that a step divides by: where water is folded over, steps stay short.
PELAGIC_SHADER_CONSTANT float kLeastJacobian = 0.2f;
// Longest step [m]: a sea that is folded over and over would throw the iteration off the Earth.
PELAGIC_SHADER_CONSTANT float kLongestStep = 64.0f;
// No face is steeper than this for longer than a step of half a cell.
PELAGIC_SHADER_CONSTANT float kSteepestFace = 1.5f;
// Steps along a ray that the GPU takes at most.
PELAGIC_SHADER_CONSTANT uint kMostRaySteps = 4096u;
PELAGIC_SHADER_CONSTANT uint kQueryThreads = 64u;

struct WaveMotionPush {
  // 64-bit fraction of time / loop period.
  uint fractionHigh;
  uint fractionLow;
  // Of the sea that comes in the amplitudes, 0 ... 1, and its derivatives in time [1/s, 1/s^2].
  float share;
  float shareRate;
  float shareAcceleration;
  float radiansPerCycle;  // 2 pi / loop period [rad/s]
};

struct QueryPush {
  // 1 / L of each cascade [1/m].
  vec4 turnsPerMetre[2];
  uint count;      // of points or rays
  float halfCell;  // half a cell of the finest cascade [m]
  float gainSamplesPerMetre;
  float unused;
};

// A ray from where it enters the layer between the lowest trough and the highest crest.
struct QueryRay {
  vec4 direction;  // xyz unit
  float height;    // of the start [m]
  float reach;     // [m]; negative: it never enters
  vec2 unused;
};

// Positions are relative to the start of the point or ray.
struct QueryResult {
  vec4 normal;        // w: height [m]
  vec4 velocity;      // [m/s]; w: 1 where a ray has met the surface
  vec4 acceleration;  // [m/s^2]
  vec2 point;         // (x, z) [m]
  vec2 undisplaced;   // (x, z) of the same water at rest, relative to `point` [m]
};

PELAGIC_SHADER_END

#endif
