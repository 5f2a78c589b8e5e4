#version 460
// Sorts the tiles of a view into lists: what no list holds costs nothing in the passes that follow.
#extension GL_GOOGLE_include_directive : require
#include "composite/bindings.glsl"
#include "composite/footprint.glsl"

// A tile an invocation: the work for a tile is small, and so no invocation waits for others.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 1, std430) writeonly buffer Tiles { uint tileWords[]; };

// The water of a tile that is nearest to the eye.
struct Water {
  float distance;  // along the camera's axis [m], less than 0 without water
  vec2 position;   // undisplaced, from the eye [m]
  float farthest;  // distance of the farthest, which may lie on another wave [m],
  float depth;     // and how far the two are apart on the undisplaced sea [m]
  bool everywhere; // no pixel of the tile is without water
};

Water waterOf(uvec2 first) {
  float least = -1.0, most = -1.0;
  bool everywhere = true;
  ivec2 nearest = ivec2(first), farthest = ivec2(first);
  for (uint i = 0u; i < kTileSize * kTileSize; ++i) {
    uvec2 place = first + uvec2(i % kTileSize, i / kTileSize);
    place = min(place, uvec2(frame.width - 1u, frame.height - 1u));
    Pixel pixel = readPixel(ivec2(place));
    float axial = pixel.water ? max(axialDistance(pixel.waterDepth), 0.0) : -1.0;
    if (axial >= 0.0 && (least < 0.0 || axial < least)) {
      least = axial;
      nearest = ivec2(place);
    }
    everywhere = everywhere && pixel.water;
    if (axial > most) {
      most = axial;
      farthest = ivec2(place);
    }
  }
  vec2 position = texelFetch(waterPosition, nearest, 0).xy;
  return Water(least, position, most, distance(position, texelFetch(waterPosition, farthest, 0).xy),
               everywhere);
}

// How much a wave's face may lean toward the eye [rad].
const float kSteepFace = 0.3;

// Steepest of the views through a tile's corners: sine of the angle to the water.
float steepestView(uvec2 tile) {
  float result = 0.0;
  for (uint corner = 0u; corner < 4u; ++corner) {
    vec3 ray = pixelRay(ivec2((tile + uvec2(corner & 1u, corner >> 1)) * kTileSize));
    result = max(result, -ray.y * inversesqrt(dot(ray, ray)));
  }
  return min(result + kSteepFace, 1.0);
}

// Cascades with any foam near a tile's water. A mip's texel is 0 only where all under it are, and the level is
// so coarse that half a texel, which is what a lookup reaches to at least, holds the tile and what its pixels blend into it:
// a texel of their own mips. Where foam may be strewn, the level is the whole patch.
uint foamingCascades(Water water, float view) {
  float across = water.distance * frame.waterAlbedo.w;
  float side = across / clamp(view - kSteepFace, 0.02, 1.0);
  uint mask = 0u;
  vec2 q = water.position + waveWarp(frame.waves.warp, water.position);
  for (uint c = 0u; c < frame.waves.cascades; ++c) {
    vec4 placement = frame.waves.placement[c];
    float texel = placement.w / float(frame.waves.size);
    float reach = 2.0 * max(float(kTileSize) * side, water.depth) + 4.0 * max(side, texel) +
                  2.0 * foamDrift();
    bool strewn = water.farthest * frame.waterAlbedo.w * placement.x * kStrewnFootprint > 1.0;
    float lod = strewn ? frame.waves.maxLod
                       : min(ceil(waveLod(placement, float(frame.waves.size), reach)), frame.waves.maxLod);
    float foam = textureLod(foamMap, vec3(waveUv(placement, q), float(c)), lod).r;
    mask |= foam > 0.0 ? 1u << c : 0u;
  }
  return mask;
}

// `word`: what a pass is told of the tile.
void append(uint list, uvec2 tile, uint word) {
  uint index = atomicAdd(tileWords[4u * list + 3u], 1u);
  atomicMax(tileWords[4u * list], min(index + 1u, kTilesPerRow));
  atomicMax(tileWords[4u * list + 1u], index / kTilesPerRow + 1u);
  uint place = kTileListStart + 2u * (list * frame.tiles + index);
  tileWords[place] = tile.x | tile.y << 16;
  tileWords[place + 1u] = word;
}

void main() {
  uvec2 tile = gl_GlobalInvocationID.xy;
  if (tile.x * kTileSize >= frame.width || tile.y * kTileSize >= frame.height) return;
  Water water = waterOf(tile * kTileSize);
  bool night = light.skyIrradiance.w > 1.0 || any(greaterThan(light.moonRadiance.rgb, vec3(0)));
  if (!water.everywhere) append(night ? kNightTiles : kSkyTiles, tile, 0u);
  if (water.distance < 0.0) return;
  float view = steepestView(tile);
  uint foaming = foamingCascades(water, view);
  uint cascades = cascadesToSample(footprintSide(water.distance * frame.waterAlbedo.w, view));
  // Clouds hide the sea from an eye above them.
  bool veiled = kHasClouds && frame.absorption.w > light.cloudPlace.w;
  if (veiled) foaming = max(foaming, 1u);  // its pipeline samples one at least
  append(veiled ? kVeiledTiles : foaming == 0u ? kWaterTiles : kFoamTiles, tile, cascades | foaming << 8);
}
