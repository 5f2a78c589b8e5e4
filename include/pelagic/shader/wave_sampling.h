// How shaders find the sea in the wave maps: a uniform (or storage) block, filled by pelagic::waveSampling().
#ifndef PELAGIC_SHADER_WAVE_SAMPLING_H
#define PELAGIC_SHADER_WAVE_SAMPLING_H
#include "pelagic/shader/types.h"

PELAGIC_SHADER_BEGIN

// The slow warp between the sea and the patches: the sum of eight waves, in two groups of four.
struct WaveWarp {
  vec4 alongX[2];  // turns per metre along x
  vec4 alongZ[2];  // and along z
  vec4 phase[2];   // turns at the origin, within a half
  vec4 shiftX[2];  // amplitude along x [m]
  vec4 shiftZ[2];  // and along z
};

// Patches are told apart this many patches far.
PELAGIC_SHADER_CONSTANT uint kPatchesApart = 4096u;

struct WaveSampling {
  WaveWarp warp;
  // Per cascade: x 1/L [1/m], yz texture coordinate of the origin (the texel and the warp's offset included), w L [m].
  vec4 placement[8];
  // xy the patch of each cascade that the origin lies in, modulo kPatchesApart along x and z.
  vec4 patches[8];
  // Expected slope covariance of each cascade: x of dh/dx, y of dh/dz, z of both [1].
  vec4 slopeCovariance[8];
  // Share of it that linear filtering takes from the gradients of cascade c in mip m: [2 c + m / 4][m % 4] [1].
  vec4 interpolationLoss[16];
  // Slope covariance that no cascade resolves, as above; w standard deviation of the elevation [m].
  vec4 unresolved;
  // Of the map of gains, if there is one: x samples per metre, yz the origin's place in samples; w how fast foam falls
  // with the gain (foamOfGain()).
  vec4 gain;
  uint cascades;
  uint size;         // samples along a side
  float choppiness;  // [1]
  float maxLod;      // index of the last mip
};

PELAGIC_SHADER_END

#endif
