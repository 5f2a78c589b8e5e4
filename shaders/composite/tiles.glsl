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
  uint cascades;   // those that the tile has to sample
};

// A tile's word: x and y in 12 bits each, cascades in 4.
Tile readTile(uint list) {
  uint index = gl_WorkGroupID.y * kTilesPerRow + gl_WorkGroupID.x;
  Tile tile;
  tile.valid = index < tileWords[4u * list + 3u];
  uint word = tileWords[kTileListStart + list * frame.tiles + (tile.valid ? index : 0u)];
  tile.pixel = ivec2(uvec2(word & 0xfffu, word >> 12 & 0xfffu) * kTileSize + gl_LocalInvocationID.xy);
  tile.cascades = word >> 24;
  tile.valid = tile.valid && tile.pixel.x < int(frame.width) && tile.pixel.y < int(frame.height);
  return tile;
}

#endif
