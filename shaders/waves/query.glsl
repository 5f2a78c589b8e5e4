// The sea at single points: the lattice of the wave maps, linear between their texels in 32 bits (the weights of filtering
// hardware have 8). Include after "shared/query.h" and wave_sampling.h.
#ifndef PELAGIC_WAVES_QUERY_GLSL
#define PELAGIC_WAVES_QUERY_GLSL

#include "pelagic/shader/wave_gain.glsl"
#include "pelagic/shader/wave_lookup.glsl"

layout(local_size_x = kQueryThreads) in;
layout(constant_id = 0) const uint kSize = 256;
layout(constant_id = 1) const uint kCascades = 4;
// Whether the water's motion is asked for.
layout(constant_id = 2) const bool kMotion = true;
layout(constant_id = 3) const bool kGain = false;

layout(set = 0, binding = 0) uniform sampler2DArray displacementMap;
layout(set = 0, binding = 1) uniform sampler2DArray gradientMap;
layout(set = 0, binding = 2) uniform sampler2DArray momentsMap;
layout(set = 0, binding = 3, std430) readonly buffer Motion { vec4 motion[]; };
// Of every point or ray in every cascade: its start's place in the patch, 2^32 a patch. All points of cascade 0 first. After
// the last cascade: its place in the map of gains, in samples, as floats; then, four times, two phases of the warp there.
layout(set = 0, binding = 4, std430) readonly buffer Starts { uvec2 starts[]; };
layout(set = 0, binding = 5, std430) readonly buffer Rays { QueryRay rays[]; };
layout(set = 0, binding = 6, std430) writeonly buffer Results { QueryResult results[]; };
layout(set = 0, binding = 7) uniform sampler2DArray gainMap;
layout(set = 0, binding = 8, std430) readonly buffer Warp { WaveWarp still; };  // without phases
layout(push_constant) uniform Push { QueryPush push; };

float turnsPerMetre(uint cascade) { return push.turnsPerMetre[cascade / 4][cascade % 4]; }

// Patches in units of 2^-32, wrapping like the starts.
uvec2 turnsOf(vec2 patches) {
  const vec2 rest = patches - floor(patches + 0.5);
  return uvec2(ivec2(min(rest * 4294967296.0, 2147483520.0)));
}

// Of this invocation's item: where it starts. Read once, before any loop: Mesa's software device hands values that a
// loop reads or computes anew each time out wrong to lanes that leave it early.
uvec2 start[8];
vec2 gainStart;
WaveWarp warp;  // of places relative to the start

void load(uint item) {
  [[unroll]] for (uint c = 0; c < kCascades; ++c) start[c] = starts[c * push.count + item];
  gainStart = kGain ? uintBitsToFloat(starts[kCascades * push.count + item]) : vec2(0);
  warp = still;
  const uint first = (kCascades + 1) * push.count + item;
  warp.phase[0] = uintBitsToFloat(uvec4(starts[first], starts[first + push.count]));
  warp.phase[1] = uintBitsToFloat(uvec4(starts[first + 2 * push.count], starts[first + 3 * push.count]));
}

// Gain of a cascade's waves, and its slopes [1/m].
vec3 gainAt(uint cascade, vec2 place) {
  if (!kGain) return vec3(1, 0, 0);
  return waveGainAt(gainMap, gainStart + place * push.gainSamplesPerMetre, cascade) *
         vec2(1, push.gainSamplesPerMetre).xyy;
}

// Four texels of a cascade and the shares of the far ones.
struct Place {
  uint cascade;
  uvec2 low, high;
  vec2 share;
};

// From the start to `target` and on to `offset` [m], which the warp is added to.
Place placeOf(uint cascade, vec2 target, vec2 offset) {
  const float scale = turnsPerMetre(cascade);
  const uvec2 turns = start[cascade] + turnsOf(target * scale) + turnsOf(offset * scale);
  const uint shift = 32 - findMSB(kSize);
  Place place;
  place.cascade = cascade;
  place.low = turns >> shift;
  place.high = (place.low + 1) & (kSize - 1);
  place.share = vec2(turns & ((1u << shift) - 1)) * exp2(-float(shift));
  return place;
}

struct Corners {
  vec4 nearLow, nearHigh, farLow, farHigh;  // near and far along z, low and high along x
};

vec4 between(Corners c, vec2 share) {
  return mix(mix(c.nearLow, c.nearHigh, share.x), mix(c.farLow, c.farHigh, share.x), share.y);
}

// All that is read of the wave maps goes through here.
Corners cornersOf(sampler2DArray map, Place p) {
  const int layer = int(p.cascade);
  return Corners(texelFetch(map, ivec3(p.low, layer), 0), texelFetch(map, ivec3(p.high.x, p.low.y, layer), 0),
                 texelFetch(map, ivec3(p.low.x, p.high.y, layer), 0), texelFetch(map, ivec3(p.high, layer), 0));
}

// As above of the motion, in the order (Dx, h, Dz). `order`: of the derivative in time less 1.
vec3 motionAt(uint order, Place p) {
  const uint plane = (2 * p.cascade + order) * kSize * kSize;
  const uint near = plane + p.low.y * kSize;
  const uint far = plane + p.high.y * kSize;
  return between(Corners(motion[near + p.low.x], motion[near + p.high.x], motion[far + p.low.x],
                         motion[far + p.high.x]), p.share).xzy;
}

// (Dx, h, Dz) and its slope between the texels [per m], in which the warp's own, a few hundredths of it, is left out.
struct Local {
  vec3 value, alongX, alongZ;
};

void addLocal(uint cascade, vec2 target, vec2 offset, vec2 shift, inout Local local) {
  const Place place = placeOf(cascade, target, offset + shift);
  const Corners c = cornersOf(displacementMap, place);
  const float texelsPerMetre = turnsPerMetre(cascade) * float(kSize);
  const vec3 nearRow = c.nearHigh.xyz - c.nearLow.xyz;
  const vec3 farRow = c.farHigh.xyz - c.farLow.xyz;
  const vec3 low = c.nearLow.xyz + nearRow * place.share.x;
  const vec3 rise = c.farLow.xyz + farRow * place.share.x - low;
  const vec3 value = low + rise * place.share.y;
  const vec3 gain = gainAt(cascade, target + offset);
  local.value += gain.x * value;
  local.alongX += gain.x * (nearRow + (farRow - nearRow) * place.share.y) * texelsPerMetre + gain.y * value;
  local.alongZ += gain.x * rise * texelsPerMetre + gain.z * value;
}

// The water that is displaced to a place, with the warp there, as good as linear so close by: its rest relative to the
// place [m], and its height [m].
struct Found {
  vec2 offset;
  float height;
};

// Newton's iteration, which the warp's slopes would not quicken, from `target`, the (x, z) of the place relative to the start [m].
Found find(vec2 target, vec2 shift, mat2 slopes) {
  Found found = Found(vec2(0), 0);
  uint steps = 0;
  bool misses;
  do {
    Local local = Local(vec3(0), vec3(0), vec3(0));
    const vec2 warped = shift + slopes * found.offset;
    [[unroll]] for (uint c = 0; c < kCascades; ++c) addLocal(c, target, found.offset, warped, local);
    const vec2 miss = found.offset + local.value.xz;
    const vec3 x = local.alongX;
    const vec3 z = local.alongZ;
    const float determinant = max((1 + x.x) * (1 + z.z) - x.z * z.x, kLeastJacobian);
    vec2 step = vec2((1 + z.z) * miss.x - z.x * miss.y, (1 + x.x) * miss.y - x.z * miss.x) / -determinant;
    step *= kLongestStep / max(length(step), kLongestStep);
    found.offset += step;
    // Always true; it makes the height a value that the loop carries, see `start`.
    if (steps < kNewtonSteps) found.height = local.value.y + x.y * step.x + z.y * step.y;
    misses = dot(miss, miss) >= kLeastMiss * kLeastMiss;
  } while (misses && ++steps < kNewtonSteps);
  return found;
}

float heightAt(vec2 target) { return find(target, waveWarp(warp, target), waveWarpSlopes(warp, target)).height; }

void storeSurface(uint item, vec2 target, bool met) {
  const vec2 shift = waveWarp(warp, target);
  const mat2 slopes = waveWarpSlopes(warp, target);
  const Found found = find(target, shift, slopes);
  // P_x and P_z of P = (x + Dx, h, z + Dz), and its derivatives over the patches.
  vec3 alongX = vec3(1, 0, 0);
  vec3 alongZ = vec3(0, 0, 1);
  vec3 patchX = vec3(0);
  vec3 patchZ = vec3(0);
  const vec2 rest = target + found.offset;
  const vec2 warped = shift + slopes * found.offset;
  vec3 velocity = vec3(0);
  vec3 acceleration = vec3(0);
  [[unroll]] for (uint c = 0; c < kCascades; ++c) {
    const Place place = placeOf(c, target, found.offset + warped);
    const vec3 gain = gainAt(c, rest);
    const vec4 g = between(cornersOf(gradientMap, place), place.share);
    const float twist = between(cornersOf(momentsMap, place), place.share).w;  // dDz/dx
    patchX += gain.x * vec3(g.z, g.x, twist);
    patchZ += gain.x * vec3(twist, g.y, g.w);
    if (kGain) {
      const vec3 d = between(cornersOf(displacementMap, place), place.share).xyz;
      alongX += gain.y * d;
      alongZ += gain.z * d;
    }
    if (kMotion) {
      velocity += gain.x * motionAt(0, place);
      acceleration += gain.x * motionAt(1, place);
    }
  }
  const mat2 stretch = mat2(1) + slopes;
  alongX += mat2x3(patchX, patchZ) * stretch[0];
  alongZ += mat2x3(patchX, patchZ) * stretch[1];
  const vec3 normal = cross(alongZ, alongX);
  const float size = length(normal);
  QueryResult result;
  result.normal = vec4(size > 0 ? normal / size : vec3(0, 1, 0), found.height);
  result.velocity = vec4(velocity, met ? 1 : 0);
  result.acceleration = vec4(acceleration, 0);
  result.point = target;
  result.undisplaced = found.offset;
  results[item] = result;
}

#endif
