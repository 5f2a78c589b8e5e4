// Sizes of the sky stage's maps and what its passes are told.
#ifndef PELAGIC_SKY_PASS_H
#define PELAGIC_SKY_PASS_H
#include "pelagic/shader/types.h"

PELAGIC_SHADER_BEGIN

PELAGIC_SHADER_CONSTANT uint kTransmittanceWidth = 256;
PELAGIC_SHADER_CONSTANT uint kTransmittanceHeight = 64;
PELAGIC_SHADER_CONSTANT uint kScatteringWidth = 64;   // over the sun's elevation
PELAGIC_SHADER_CONSTANT uint kScatteringHeight = 16;  // over altitude
// Clear sky relative to the sun: u = sqrt(azimuth from the sun / pi), in the upper kClearSize rows v = sqrt of the elevation
// over the eye's horizon as a part of the way to the zenith; a view has rows below its horizon as well.
PELAGIC_SHADER_CONSTANT uint kClearSize = 128;
PELAGIC_SHADER_CONSTANT uint kAirRows = 32;
PELAGIC_SHADER_CONSTANT uint kRadianceWidth = 512;
PELAGIC_SHADER_CONSTANT uint kRadianceHeight = 256;
PELAGIC_SHADER_CONSTANT uint kEnvironmentSize = 256;
PELAGIC_SHADER_CONSTANT uint kSkyTile = 8;  // side of a work-group that writes a map

// Push constants of all passes.
struct SkyPass {
  vec4 sunDirection;  // xyz toward the sun (world), w elevation [rad]
  float sunAzimuth;   // [rad]
  float overcast;     // 0 ... 1
  float haze;         // [1]
  float gain;         // factor on every radiance, 1 while the sun is up
  float altitude;     // of the eye [m]
  float edge;         // elevation of the eye's horizon [rad], <= 0
  uint airRows;       // rows below the horizon: 0, or kAirRows in the maps of a view
  uint padding;
};

PELAGIC_SHADER_END

#endif
