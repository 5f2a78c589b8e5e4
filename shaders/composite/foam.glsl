// Foam: a dense core where a crest breaks, torn to lace and drawn out along the wind as it ages, a film of bubbles in the end.
#ifndef PELAGIC_COMPOSITE_FOAM_GLSL
#define PELAGIC_COMPOSITE_FOAM_GLSL
#include "composite/sea_slopes.glsl"
#include "physics/noise.glsl"

// The foam's texture: a field of ridges that close into cells, so that what stands above a high level is lace.
struct FoamPattern {
  float height;      // what the footprint resolves of it
  float unresolved;  // standard deviation of the rest
};
const uint kFoamOctaves = 7u;
const float kRidgeMean = 0.644;       // of 1 - |2 n - 1|
const float kRidgeDeviation = 0.237;
const float kFirstWeight = 0.42, kNextWeight = 0.82;
const float kWhole = 0.1685;          // standard deviation of the whole pattern
const vec2 kDrawnOut = vec2(0.3, -0.15);  // by how much a ridge moves the finer cells on it, in cells

// `q`: wind frame, in lattice cells of one metre across the wind and two along. `footprint` [m]. Octaves that it does not
// resolve cost nothing.
FoamPattern foamPattern(vec2 q, float footprint) {
  uvec2 cells = uvec2(uint(kFoamPeriod));
  float weight = kFirstWeight;
  float cell = 1.0;
  float height = 0.0, resolved = 0.0;
  uint octave = 0u;
  do {
    float kept = weight * clamp(1.5 - 2.0 * footprint / cell, 0.0, 1.0);
    float ridge = 1.0 - abs(2.0 * latticeNoise(q, cells) - 1.0) - kRidgeMean;
    height += kept * ridge;
    resolved += kept * kept;
    // Turned and shrunk by whole numbers, so that every octave repeats with the first; the finer are drawn out by the coarser.
    q = vec2(2.0 * q.x + q.y, 2.0 * q.y - q.x) + kDrawnOut * ridge;
    cell *= 0.4472136;
    weight *= kNextWeight;
  } while (++octave < kFoamOctaves && footprint < 0.75 * cell);
  float whole = kWhole / kRidgeDeviation;
  return FoamPattern(height, kRidgeDeviation * sqrt(max(whole * whole - resolved, 0.0)));
}

struct Foam {
  float cover;    // share of the pixel under foam
  float opacity;  // of that foam
  float shade;    // of its brightness, near 1 in the mean, 1 far off
  vec2 slope;     // of its top: away from the eye and to the left of that, from x over to -z
};
const float kFoamAlbedo = 0.8;  // of foam that hides the water
const float kFoamHeight = 0.3;  // of a unit of the pattern [m]
const float kFoamOpacity = 35.0;  // half the transport optical depth of a unit of the pattern
const float kFoamShade = 3.0;  // logarithm of how much a unit of the pattern brightens foam: less light reaches its hollows

const int kFoamTaps = 3;  // two in a row and one beside them tell a slope
// An edge is no line: bubbles thin out over this deviation of the pattern. What stands above a level has that and the pattern's.
const float kFoamEdge = 0.08;
const float kFoamLevels = 0.18653;  // root of kWhole^2 + kFoamEdge^2

// The share of the sea above a level of the pattern is what the freshness asks for, at every distance: near by the level
// cuts lace out of the pattern, far off the share itself is what is left. The pixel covers `along` [m] of the water away
// from the eye and `across`: taps in a row, each as wide as its part of the longer side. `lane`: how far old foam gathers here.
Foam foamAt(float freshness, float lane, vec2 p, float across, vec2 along) {
  vec2 q = (frame.foam.xy + alongWind(p)) * vec2(0.5, 1.0);
  // In a strong wind older foam gathers in streaks along it.
  float gathered = mix(1.0, max(4.0 * lane - 1.0, 0.0), frame.thinCrest.w);
  float aged = clamp(freshness * gathered, 0.0, 1.0);
  float share = clamp(mix(aged, freshness, freshness), 0.0, 0.995);
  // Normal quantiles by the logistic, Phi(z) ~ 1 / (1 + e^(-1.702 z)).
  float level = kFoamLevels / 1.702 * log((1.0 - share) / max(share, 1e-4));

  // Torn, where the lanes' field is steep.
  q += vec2(3.0, 0.7) * lane;
  vec2 step = alongWind(along) * vec2(0.5, 1.0) / float(kFoamTaps);
  float footprint = max(across, length(along) / float(kFoamTaps));
  // The middle one to the left of the others, so that they tell the relief's slope that way too.
  vec2 left = alongWind(vec2(along.y, -along.x)) * vec2(0.5, 1.0) * (footprint / max(length(along), 1e-6));
  q -= step * (0.5 * float(kFoamTaps - 1)) + left / 3.0;
  float density = kFoamOpacity * mix(0.6, 1.0, smoothstep(0.1, 0.6, freshness));  // bubbles burst with age
  float middle = -kFoamLevels / 1.702 * log(1.0 - share) / max(share, 1e-4);  // thickness of what is covered, in the mean
  float cover = 0.0, hidden = 0.0, shade = 0.0, heights[kFoamTaps];
  int tap = 0;
  do {
    FoamPattern pattern = foamPattern(tap == 1 ? q + left : q, footprint);
    // A layer of bubbles as thick as the pattern stands above the level.
    float spread = sqrt(pattern.unresolved * pattern.unresolved + kFoamEdge * kFoamEdge);
    float x = 1.702 * clamp((pattern.height - level) / spread, -20.0, 20.0);
    float part = 1.0 / (1.0 + exp(-x));
    float thickness = spread * log(1.0 + exp(x)) / (1.702 * part);
    cover += part;
    shade += part * min(exp(kFoamShade * (thickness - middle)), 1.0 / kFoamAlbedo);
    // Two streams through a layer that absorbs nothing (Bohren 1987), so that a dense core still shows where it is thicker;
    // the mean over what is unresolved to the second order, thickness being Gamma distributed.
    float depth = thickness * density;
    float varied = min(pattern.unresolved * pattern.unresolved / max(thickness * thickness, 1e-6), 1.0);
    float shown = depth / (1.0 + depth);
    hidden += part * shown * (1.0 - varied * shown / (1.0 + depth));
    heights[tap] = pattern.height;
    q += step;
  } while (++tap < kFoamTaps);
  Foam foam;
  foam.cover = min(share * 1000.0, 1.0) * cover / float(kFoamTaps);
  foam.opacity = hidden / max(cover, 1e-4);
  foam.shade = shade / max(cover, 1e-4);
  foam.slope = kFoamHeight * vec2((heights[2] - heights[0]) * float(kFoamTaps) / (float(kFoamTaps - 1) * max(length(along), 0.01)),
                                 (heights[1] - 0.5 * (heights[0] + heights[2])) / max(footprint, 0.005));
  return foam;
}

// Share of a light from l that foam on the sea takes, of the normal n, where its relief has the normal `top` per unit of n. As
// much is taken from a side as is given to the other, none of it below 0 or above 1: in the mean, the light on the sea.
float litFoam(vec3 n, vec3 top, vec3 l) {
  float level = clamp(dot(n, l), 0.0, 1.0);
  float room = min(level, 1.0 - level);
  return level + clamp(dot(top - n, l), -room, room);
}

#endif
