// Foam: a dense core where a crest breaks, torn to lace and drawn out along the wind as it ages.
#ifndef PELAGIC_COMPOSITE_FOAM_GLSL
#define PELAGIC_COMPOSITE_FOAM_GLSL
#include "physics/noise.glsl"

// The foam's texture: a field of ridges that close into cells, so that what stands above a high level is lace.
struct FoamPattern {
  float height;      // what the footprint resolves of it
  float unresolved;  // standard deviation of the rest
};
const uint kFoamOctaves = 5u;
const float kRidgeMean = 0.644;       // of 1 - |2 n - 1|
const float kRidgeDeviation = 0.237;

// `q`: wind frame, in lattice cells of one metre across the wind and two along. `footprint` [m].
FoamPattern foamPattern(vec2 q, float footprint) {
  FoamPattern pattern = FoamPattern(0.0, 0.0);
  uvec2 cells = uvec2(uint(kFoamPeriod));
  float weight = 0.42;
  float cell = 1.0;
  for (uint octave = 0u; octave < kFoamOctaves; ++octave) {
    float kept = clamp(1.5 - 2.0 * footprint / cell, 0.0, 1.0);
    float ridge = 1.0 - abs(2.0 * latticeNoise(q, cells) - 1.0);
    pattern.height += weight * kept * (ridge - kRidgeMean);
    pattern.unresolved += weight * weight * (1.0 - kept * kept);
    // Turned and shrunk by whole numbers, so that every octave repeats with the first.
    q = vec2(2.0 * q.x + q.y, 2.0 * q.y - q.x);
    cell *= 0.4472136;
    weight *= 0.85;
  }
  pattern.unresolved = kRidgeDeviation * sqrt(pattern.unresolved);
  return pattern;
}

struct Foam {
  float cover;   // share of the pixel under foam
  float albedo;
};

const int kFoamTaps = 3;

// The share of the sea above a level of the pattern is what the freshness asks for, at every distance: near by the level
// cuts lace out of the pattern, far off the share itself is what is left. The pixel covers `along` [m] of the water away
// from the eye and `across`: taps in a row, each as wide as its part of the longer side.
Foam foamAt(float freshness, vec2 p, float across, vec2 along) {
  const float kWhole = 0.169;  // standard deviation of the whole pattern
  const float kEdge = 0.04;     // softness of an edge near by
  vec2 wind = frame.foam.zw;
  vec2 q = (frame.foam.xy + vec2(dot(p, wind), dot(p, vec2(-wind.y, wind.x)))) * vec2(0.5, 1.0);
  // In a strong wind older foam gathers in streaks along it.
  float streak = latticeNoise(q * vec2(0.0625, 0.25), uvec2(32u, 128u));
  float mixed = mix(0.5, streak, frame.thinCrest.w * clamp(1.5 - 0.25 * length(along), 0.0, 1.0));  // four metres wide
  float aged = clamp(freshness * (0.4 + 1.2 * mixed), 0.0, 1.0);
  float share = clamp(mix(aged, freshness, freshness), 0.0, 0.98);
  // Normal quantiles by the logistic, Phi(z) ~ 1 / (1 + e^(-1.702 z)).
  float level = kWhole / 1.702 * log((1.0 - share) / max(share, 1e-4));

  // Torn, where the streaks' field is steep.
  q += vec2(3.0, 0.7) * streak;
  vec2 step = vec2(dot(along, wind), dot(along, vec2(-wind.y, wind.x))) * vec2(0.5, 1.0) / float(kFoamTaps);
  float footprint = max(across, length(along) / float(kFoamTaps));
  q -= step * (0.5 * float(kFoamTaps - 1));
  float cover = 0.0, light = 0.0;
  int tap = 0;
  do {
    FoamPattern pattern = foamPattern(q, footprint);
    float above = pattern.height - level;
    float part = 1.0 / (1.0 + exp(-1.702 * clamp(above / max(pattern.unresolved, kEdge), -30.0, 30.0)));
    // Thin toward the edges of a patch.
    cover += part;
    light += part * clamp(0.1 + 2.5 * above, 0.0, 1.0);
    q += step;
  } while (++tap < kFoamTaps);
  float thickness = light / max(cover, 1e-4);
  Foam foam;
  foam.cover = min(share * 50.0, 1.0) * cover / float(kFoamTaps);
  // And thinner with age.
  foam.albedo = mix(0.25, 0.78, thickness * mix(0.5, 1.0, smoothstep(0.4, 0.85, freshness)));
  return foam;
}

#endif
