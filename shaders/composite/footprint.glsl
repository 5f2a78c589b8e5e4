// How much of a cascade a pixel can resolve.
#ifndef PELAGIC_COMPOSITE_FOOTPRINT_GLSL
#define PELAGIC_COMPOSITE_FOOTPRINT_GLSL
#include "pelagic/shader/wave_lookup.glsl"
#include "physics/sheet.glsl"

// Longest side of the square that stands for a pixel's footprint, in pixels' widths.
const float kLongestSide = 48.0;

// The maps' mips are square, a pixel's footprint on the water is an ellipse `across` [m] wide and drawn out by the slant of
// the view, of which `slant` is the sine. A square stands for it whose side lies between the ellipse's two, nearer the
// longer one and far off half of that: what it leaves unresolved across is variance, what it misses along shows as slope, so
// that no variance is lost. A larger one smears the ripples of near water into streaks, a smaller one lets far water sparkle.
float footprintSide(float across, float slant) {
  float root = inversesqrt(max(slant, 1e-4));
  return across * clamp(root * max(sqrt(root), 0.5 * root), 1.0, kLongestSide);
}

// A cascade holds no wave longer than 1/16 of its patch (pelagic::waveLayout), so that a footprint of that length [m]
// leaves nothing of it but its variance.
const float kLongestWave = 1.0 / 16.0;

// How far a gale draws old foam out to either side along itself [m]. The drift of the surface, 3 % of a wind of 18 m/s (Wu 1975),
// is 4.3 m in the 8 s that the maps keep foam; real streaks outlive that.
const float kFoamDrift = 10.0;
// And how far the wind of this sea does: at least 2 m, the drift at 8 m/s.
float foamDrift() { return kFoamDrift * max(frame.thinCrest.w, 0.2); }

// Pixels wider than this part of a patch see its foam strewn, from twice that on altogether.
const float kStrewnFootprint = 700.0;

// Covariance of the slopes that maps sampled at the footprint [m] show, as expected.
vec3 resolvedCovariance(float footprint) {
  float place = clamp(log2(max(footprint * frame.sheet.y, 1.0)), 0.0, float(kFootprints) - 1.001);
  uint i = uint(place);
  return mix(frame.resolved[i].xyz, frame.resolved[i + 1u].xyz, place - float(i));
}

// The same of what pixels `across` wide [m] show at the footprint `side` and the sheet is too coarse for, where a flat sea is
// seen at the sine `height`.
vec3 withoutRelief(float side, float across, float height) {
  float waves = clamp(1.0 - across / max(frame.waves.unresolved.w, 1e-6), 0.0, 1.0);
  // Linear between points `cell` apart, the sheet shows more of a wave than maps smoothed over that length: of its slopes as
  // much as they do over 0.58 of it, of its heights, which hide, as over 0.82. What lies between is fitted to the far sea's
  // energy (ocean_energy_test).
  float cell = 0.75 * frame.sheet.x * across / rowsPerWidth(height, waves);
  return resolvedCovariance(side) - resolvedCovariance(max(cell, side));
}

// Cascades, counted from the longest, of which something is left at the footprint.
uint cascadesToSample(float footprint) {
  uint count = 0u;
  for (uint c = 0u; c < notWrittenIn(frame.waves.cascades); ++c) {
    if (footprint < frame.waves.placement[c].w * kLongestWave) count = c + 1u;
  }
  return count;
}

#endif
