#version 460
// Sorts the tiles of a view into lists: what no list holds costs nothing in the passes that follow.
#extension GL_GOOGLE_include_directive : require
#include "composite/bindings.glsl"
#include "composite/footprint.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 1, std430) writeonly buffer Tiles { uint tileWords[]; };

shared uint anyWater;
shared uint nearestBits;  // smallest axial distance of the tile's water, as the bits of a positive float

void main() {
  if (gl_LocalInvocationIndex == 0u) {
    anyWater = 0u;
    nearestBits = floatBitsToUint(1e30);
  }
  barrier();
  ivec2 place = ivec2(gl_GlobalInvocationID.xy);
  if (place.x < int(frame.width) && place.y < int(frame.height)) {
    Pixel pixel = readPixel(place);
    if (pixel.water) {
      atomicOr(anyWater, 1u);
      atomicMin(nearestBits, floatBitsToUint(max(axialDistance(pixel.waterDepth), 0.0)));
    }
  }
  barrier();
  if (gl_LocalInvocationIndex == 0u) {
    uint list = anyWater != 0u ? kWaterTiles : kSkyTiles;
    uint index = atomicAdd(tileWords[4u * list + 3u], 1u);
    atomicMax(tileWords[4u * list], min(index + 1u, kTilesPerRow));
    atomicMax(tileWords[4u * list + 1u], index / kTilesPerRow + 1u);
    uint cascades = cascadesToSample(uintBitsToFloat(nearestBits) * frame.waterAlbedo.w);
    tileWords[kTileListStart + list * frame.tiles + index] =
        gl_WorkGroupID.x | gl_WorkGroupID.y << 12 | cascades << 24;
  }
}
