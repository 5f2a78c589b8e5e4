// Sizes of the sky stage's maps and what its passes are told.
#ifndef PELAGIC_SKY_PASS_H
#define PELAGIC_SKY_PASS_H
#include "pelagic/shader/types.h"

PELAGIC_SHADER_BEGIN

PELAGIC_SHADER_CONSTANT uint kTransmittanceWidth = 256;
PELAGIC_SHADER_CONSTANT uint kTransmittanceHeight = 64;
PELAGIC_SHADER_CONSTANT uint kScatteringWidth = 64;   // over the sun's elevation
PELAGIC_SHADER_CONSTANT uint kScatteringHeight = 16;  // over altitude
// Clear sky relative to the sun: u = sqrt(azimuth from the sun / pi), in the upper kClearSize rows v = sqrt of the
// elevation over the eye's horizon as a part of the way to the zenith; a view has rows below its horizon as well.
PELAGIC_SHADER_CONSTANT uint kClearSize = 128;
PELAGIC_SHADER_CONSTANT uint kAirRows = 32;
PELAGIC_SHADER_CONSTANT uint kRadianceWidth = 512;
PELAGIC_SHADER_CONSTANT uint kRadianceHeight = 256;
PELAGIC_SHADER_CONSTANT uint kEnvironmentSize = 256;
PELAGIC_SHADER_CONSTANT uint kSkyTile = 8;  // side of a work-group that writes a map
// The clouds' volume: cells along x and z of a tile that repeats, and layers from base to top.
PELAGIC_SHADER_CONSTANT uint kCloudCells = 256;
PELAGIC_SHADER_CONSTANT uint kCloudLayers = 32;
PELAGIC_SHADER_CONSTANT float kCloudTile = 15360.0f;      // [m]
PELAGIC_SHADER_CONSTANT uint kCloudDetail = 64;           // texels along a side of the detail's cube
PELAGIC_SHADER_CONSTANT float kCloudDetailTile = 480.0f;  // its side [m], a whole part of kCloudTile
PELAGIC_SHADER_CONSTANT uint kDomeSize = 96;              // side of the clouds' stereographic map
PELAGIC_SHADER_CONSTANT uint kCloudPixels = 2;            // pixels of a view along a side of one of its clouds' pixels

// Push constants of all passes.
struct SkyPass {
  vec4 sunDirection;   // xyz toward the sun (world), w elevation [rad]
  float sunAzimuth;    // [rad]
  float overcast;      // 0 ... 1
  float gain;          // factor on every radiance, 1 while the sun is up
  float altitude;      // of the eye [m]
  float edge;          // elevation of the eye's horizon [rad], <= 0
  uint airRows;        // rows below the horizon: 0, or kAirRows in the maps of a view
  float moonAzimuth;   // [rad]
  float night;         // share of the light of a moonless night that is added
  vec4 moonDirection;  // xyz toward the moon (world), w its irradiance over the air, 0 below the horizon
  vec4 sunPlace;       // xyz toward the sun, also where sunDirection is the moon's, w 1: the moon casts the shadows
  vec4 stars;          // as in SkyLight
  vec2 haze;           // aerosols: amount [1], scale height [m]
  vec2 padding;
};

// Push constants of the pass that shows a host's picture.
struct HostSkyPass {
  float turn;  // of the picture, from +x to +z [turns]
  float padding1;
  vec2 padding2;
};

// Push constants of the passes that make the volume.
struct CloudPass {
  vec4 sunDirection;  // xyz toward the sun (world)
  float base;         // altitude [m]
  float thickness;    // [m]
  float threshold;    // of a standard normal field above which there are clouds
  uint seed;          // 10 bits
  float openSea;      // how far the field falls where the weather holds clouds down
  float padding1;
  vec2 padding2;
};

// Of the passes that look at it. The direction through a pixel is ray + x rayX + y rayY; the dome's pixels are its own.
struct CloudView {
  vec4 ray;    // w: eye's altitude [m]
  vec4 rayX;   // w: altitude of the clouds' base [m]
  vec4 rayY;   // w: of their top
  vec2 place;  // of the eye, 0 ... 12 [tiles]
  float edge;  // elevation of the eye's horizon [rad]
  float cover;
  uint width;  // of the clouds' picture [px]
  uint height;
  float openSea;  // as in CloudPass
  float padding;
};

PELAGIC_SHADER_END

#endif
