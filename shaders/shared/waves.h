// What the wave stage's shaders are told from outside.
#ifndef PELAGIC_SHARED_WAVES_H
#define PELAGIC_SHARED_WAVES_H
#include "pelagic/shader/types.h"

PELAGIC_SHADER_BEGIN

// Every thread of a transform holds this many samples of its line.
PELAGIC_SHADER_CONSTANT uint kSamplesPerThread = 16u;
// Foam is kept in steps of one tick's decay: 8 s of life in ticks of 0.25 s.
PELAGIC_SHADER_CONSTANT uint kFoamSteps = 32u;
// Mips that one filter dispatch makes.
PELAGIC_SHADER_CONSTANT uint kFilterLevels = 5u;
// The buffer of cascades holds those of the sea that comes, from this index on those of the sea that goes.
PELAGIC_SHADER_CONSTANT uint kMostCascades = 8u;

// Of one cascade; changes with the sea only.
struct WaveCascade {
  float waveNumberStep;  // 2 pi / L [rad/m]
  // The elevation rides with dDz/dx in one complex transform; this factor, a power of two unless the sea is changing,
  // brings it to the same magnitude, so that the rounding errors of the larger do not drown the smaller.
  float heightScale;
  float foldThreshold;  // J_t below which the sea breaks [1]
  float inverseSpread;  // 1 / standard deviation of the Jacobian of the other foaming cascades [1]
};

struct WaveRowsPush {
  // 64-bit fraction of time / loop period.
  uint fractionHigh;
  uint fractionLow;
  // Of the sea that comes in the amplitudes, 0 ... 1; 1 when nothing changes.
  float share;
};

struct WaveColumnsPush {
  uint foamCascades;  // the first ones keep foam
  float fade;         // decay since the last tick, 0 ... 1 / kFoamSteps
  float share;        // as in WaveRowsPush
};

struct WaveFoamPush {
  uint keep;    // 1: continue the previous tick's foam, 0: there was none
  float share;  // as in WaveRowsPush
};

struct WaveFilterPush {
  uint size;    // of the source mip
  uint levels;  // to make, 1 ... kFilterLevels
  uint foamCascades;
};

PELAGIC_SHADER_END

#endif
