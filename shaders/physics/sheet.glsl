// How long the cells of the drawn sheet are. Compiles as GLSL and, through GLM, as C++.
#ifndef PELAGIC_PHYSICS_SHEET_GLSL
#define PELAGIC_PHYSICS_SHEET_GLSL
#include "physics/formula.h"

PELAGIC_PHYSICS_BEGIN

// Longest cell relative to its width where waves are large.
PELAGIC_FORMULA_CONSTANT float kLongestCell = 4.0f;
// But at most this many rows more than a flat sea needs. Crests against the sky need rows that would lie within a pixel of
// each other if the sea were flat.
PELAGIC_FORMULA_CONSTANT float kFlatter = 16.0f;

// Rows of cells over a length of water as long as a cell is wide, where the still sea is seen at the sine `height`. `waves`:
// 1 where they are as large as can be, 0 where they span no pixel.
PELAGIC_FORMULA float rowsPerWidth(float height, float waves) {
  return height + min(1.0f / kLongestCell, kFlatter * height) * waves;
}

PELAGIC_PHYSICS_END
#endif
