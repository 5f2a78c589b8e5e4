// A pass over one of the tile lists.
#ifndef PELAGIC_COMPOSITE_TILES_GLSL
#define PELAGIC_COMPOSITE_TILES_GLSL
#include "shared/composite.h"

layout(local_size_x = 8, local_size_y = 8) in;
// Per list: an indirect dispatch (x, y, 1) and the number of tiles; from kTileListStart on the lists.
layout(binding = 1, std430) readonly buffer Tiles { uint tileWords[]; };

struct Tile {
  bool valid;      // false in the last row's surplus groups
  ivec2 pixel;     // this invocation's
  uint cascades;   // how many to sample, counted from the longest
  uint foaming;    // bit mask of those with foam in the tile
};

// A tile's words: x and y in 16 bits each; cascades, and the mask in bits 8 to 15.
Tile readTile(uint list) {
  uint index = gl_WorkGroupID.y * kTilesPerRow + gl_WorkGroupID.x;
  Tile tile;
  tile.valid = index < tileWords[4u * list + 3u];
  uint word = kTileListStart + 2u * (list * frame.tiles + (tile.valid ? index : 0u));
  uint place = tileWords[word];
  tile.pixel = ivec2(uvec2(place & 0xffffu, place >> 16) * kTileSize + gl_LocalInvocationID.xy);
  tile.cascades = tileWords[word + 1u] & 0xffu;
  tile.foaming = tileWords[word + 1u] >> 8;
  tile.valid = tile.valid && tile.pixel.x < int(frame.width) && tile.pixel.y < int(frame.height);
  return tile;
}

#endif
