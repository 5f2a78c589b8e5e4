#version 460
// Sorts the tiles of a view into lists: what no list holds costs nothing in the passes that follow.
#extension GL_GOOGLE_include_directive : require
#include "composite/bindings.glsl"
#include "composite/footprint.glsl"

// A tile an invocation: the work for a tile is small, and so no invocation waits for others.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 1, std430) writeonly buffer Tiles { uint tileWords[]; };

// The water of a tile.
struct Water {
  float distance;   // of the nearest along the camera's axis [m], less than 0 without water
  float farthest;   // of the farthest, which may lie on another wave [m]
  vec2 low;         // where it lies on the undisplaced sea, from the eye [m]
  vec2 high;
  bool everywhere;  // no pixel of the tile is without water
};

Water waterOf(uvec2 first) {
  Water water = Water(-1.0, -1.0, vec2(1e30), vec2(-1e30), true);
  for (uint i = 0u; i < kTileSize * kTileSize; ++i) {
    uvec2 place = first + uvec2(i % kTileSize, i / kTileSize);
    place = min(place, uvec2(frame.width - 1u, frame.height - 1u));
    Pixel pixel = readPixel(ivec2(place));
    vec2 position = texelFetch(waterPosition, ivec2(place), 0).xy;
    float axial = pixel.water ? max(axialDistance(pixel.waterDepth), 0.0) : -1.0;
    water.distance = axial >= 0.0 && (water.distance < 0.0 || axial < water.distance) ? axial : water.distance;
    water.farthest = max(water.farthest, axial);
    water.low = pixel.water ? min(water.low, position) : water.low;
    water.high = pixel.water ? max(water.high, position) : water.high;
    water.everywhere = water.everywhere && pixel.water;
  }
  return water;
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

// Half the box that the warp can draw half a box out to: its waves' slopes are 8 times their amplitudes at most (waveWarp()).
vec2 warped(vec2 half_) {
  vec2 drawn = half_;
  for (int i = 0; i < 2; ++i) {
    vec4 slope = 8.0 * (abs(frame.waves.warp.alongX[i]) * half_.x + abs(frame.waves.warp.alongZ[i]) * half_.y);
    drawn += vec2(dot(slope, abs(frame.waves.warp.shiftX[i])), dot(slope, abs(frame.waves.warp.shiftZ[i])));
  }
  return drawn;
}

// Cascades with any foam where a tile's pixels look it up. A mip's texel is 0 only where all under it are: lookups at the
// corners of texels, each of which tells of the four around it, cover the box in which the tile's water lies and all that its
// pixels blend into it. Where foam may be strewn, that is the whole patch.
uint foamingCascades(Water water) {
  const float kMostLookups = 4.0;  // along a side of the box
  float across = water.farthest * frame.waterAlbedo.w;
  float side = across * kLongestSide;
  vec2 middle = 0.5 * (water.low + water.high);
  float drift = foamDrift() * (frame.thinCrest.w > 0.0 ? 1.0 : 0.5);  // seaPoint()'s two lookups without lanes lie halfway
  vec2 drawn = warped(0.5 * (water.high - water.low)) + drift * abs(frame.foam.zw);
  vec2 q = middle + waveWarp(frame.waves.warp, middle);
  uint mask = 0u;
  for (uint c = 0u; c < notWrittenIn(frame.waves.cascades); ++c) {
    vec4 placement = frame.waves.placement[c];
    float texel = placement.w / float(frame.waves.size);
    // Texels up to twice as long as a pixel's side are blended, and a storm moves a lookup by up to one of the finest. A
    // texel that is no longer than those of the lookups here is told of whole.
    vec2 reach = drawn + max(side, 0.5 * texel) + texel * frame.thinCrest.w;
    float step = max(2.0 * max(reach.x, reach.y) / (2.0 * kMostLookups - 1.0), 2.0 * side);
    bool strewn = across * placement.x * kStrewnFootprint > 1.0;
    float lod = min(ceil(waveLod(placement, float(frame.waves.size), step)), frame.waves.maxLod);
    lod = strewn ? frame.waves.maxLod : lod;
    float texels = float(frame.waves.size) * exp2(-lod);
    vec2 first = floor(waveUv(placement, q - reach) * texels), last = waveUv(placement, q + reach) * texels;
    ivec2 lookups = ivec2(clamp(ceil(0.5 * (last - first)), vec2(1), vec2(kMostLookups)));
    int count = lookups.x * lookups.y;
    float foam;
    int i = 0;
    do {
      vec2 corner = first + 1.0 + 2.0 * vec2(i % lookups.x, i / lookups.x);
      foam = textureLod(foamMap, vec3(corner / texels, float(c)), lod).r;
    } while (++i < count && foam == 0.0);
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
  uint foaming = foamingCascades(water);
  uint cascades = cascadesToSample(footprintSide(water.distance * frame.waterAlbedo.w, view));
  // Clouds hide the sea from an eye above them.
  bool veiled = kHasClouds && frame.absorption.w > light.cloudPlace.w;
  if (veiled) foaming = max(foaming, 1u);  // its pipeline samples one at least
  append(veiled ? kVeiledTiles : foaming == 0u ? kWaterTiles : kFoamTiles, tile, cascades | foaming << 8);
}
