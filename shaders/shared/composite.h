// What the composite passes share: one frame of one view, and the tile lists.
#ifndef PELAGIC_SHARED_COMPOSITE_H
#define PELAGIC_SHARED_COMPOSITE_H
#include "pelagic/shader/constants.h"
#include "pelagic/shader/wave_sampling.h"

PELAGIC_SHADER_BEGIN

// Side of a tile, which is a work-group [px].
PELAGIC_SHADER_CONSTANT uint kTileSize = 8u;
// Tiles of a list dispatched along x before the next row of groups starts; below every device's limit.
PELAGIC_SHADER_CONSTANT uint kTilesPerRow = 32768u;
// Tile lists. A tile may be on one of the first two and on one of the others: each pass draws its own pixels.
PELAGIC_SHADER_CONSTANT uint kSkyTiles = 0u;     // sky or the host's picture in at least one pixel
PELAGIC_SHADER_CONSTANT uint kNightTiles = 1u;   // the same with moon or stars in the sky
PELAGIC_SHADER_CONSTANT uint kWaterTiles = 2u;   // water in at least one pixel, no foam
PELAGIC_SHADER_CONSTANT uint kFoamTiles = 3u;    // water and foam
PELAGIC_SHADER_CONSTANT uint kVeiledTiles = 4u;  // water with or without foam, clouds before it
PELAGIC_SHADER_CONSTANT uint kTileLists = 5u;
// 32-bit words before the first list, whose entries have two.
PELAGIC_SHADER_CONSTANT uint kTileListStart = 20u;
// The foam pattern repeats after this many metres across the wind and twice as many along it.
PELAGIC_SHADER_CONSTANT float kFoamPeriod = 512.0f;

// The pattern of slicks repeats after this many metres.
PELAGIC_SHADER_CONSTANT float kSlickPeriod = 32768.0f;

// Bits of the shaded picture's alpha: the surface breaks off between a pixel and its neighbour.
PELAGIC_SHADER_CONSTANT uint kEdgeLeft = 1u;
PELAGIC_SHADER_CONSTANT uint kEdgeRight = 2u;
PELAGIC_SHADER_CONSTANT uint kEdgeAbove = 4u;
PELAGIC_SHADER_CONSTANT uint kEdgeBelow = 8u;
// Pixels of a work-group that smooths edges, and words before their list: an indirect dispatch and their number.
PELAGIC_SHADER_CONSTANT uint kEdgeGroup = 64u;
PELAGIC_SHADER_CONSTANT uint kEdgeListStart = 4u;

// Footprints for which CompositeFrame::resolved is known.
PELAGIC_SHADER_CONSTANT uint kFootprints = 24u;

struct CompositeFrame {
  WaveSampling waves;
  // The point of a pixel with the clip-space w is w (ray + x rayX + y rayY), world axes, from the eye; (0,0) is the
  // centre of the first pixel.
  vec4 ray;          // w: B of w = B / (depth - A) [m]
  vec4 rayX;         // w: A
  vec4 rayY;         // w: the depth of the far plane
  vec4 absorption;   // a [1/m] per channel; w: height of the eye over the still water below it [m]
  vec4 thinCrest;    // transmittance of the thinnest and; w: how far old foam gathers in streaks, 0 ... 1
  vec4 thickCrest;   // of the thickest crest that light comes through; w: elevation of the eye's horizon [rad]
  vec4 waterAlbedo;  // radiance that leaves the water per irradiance that enters it [1/sr]; w: pixel's side at w = 1
  vec4 lookAlbedo;   // the same that the look turns to; w: how far with the angle of view
  vec4 foam;         // xy: the eye's place in the foam pattern [m], zw: the wind's direction
  // xy: the eye's place in the pattern of slicks [m]; z: deviation of short waves' slope variance in it; w: 1: bubbles
  // below foam are seen, 0: the water has the colour of a look
  vec4 slicks;
  uint width;  // of the view [px]
  uint height;
  uint tiles;                            // capacity of each list
  float nearer;                          // 1: greater depth is nearer, -1: less is
  vec4 hostLightPlace[kMostHostLights];  // from the eye [m]; w: radius of a ball [m], 0 of a rectangle
  vec4 hostLightWidth[kMostHostLights];  // half-axes of a rectangle [m], 0 of a ball
  vec4 hostLightHeight[kMostHostLights];
  vec4 hostLightRadiance[kMostHostLights];  // rgb
  // Slope covariance (xx, zz, xz) that maps sampled at a footprint show, of 2^i texels of the shortest cascade each.
  vec4 resolved[kFootprints];
  vec4 slopes;         // of all the sea's slopes; w: reflectance of the sea seen from the horizon
  uint hostLights;     // that there are
  float planetRadius;  // at sea level [m]
  float skyContrast;   // factor on the sky's reflected light
  float crestsHide;    // 1: thin crests hide the water's colour, 0: not
  vec4 sheet;  // x: side of its cells [px], 0: it has all that pixels resolve; y: texels of the shortest cascade [1/m]
};

PELAGIC_SHADER_END
#endif
