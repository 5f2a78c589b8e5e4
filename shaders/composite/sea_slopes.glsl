// The sea within a pixel: mean slope, the covariance of what the pixel cannot resolve, and foam.
#ifndef PELAGIC_COMPOSITE_SEA_SLOPES_GLSL
#define PELAGIC_COMPOSITE_SEA_SLOPES_GLSL
#include "composite/footprint.glsl"
#include "physics/modulation.glsl"
#include "physics/noise.glsl"
#include "pelagic/shader/wave_lookup.glsl"
#include "pelagic/shader/wave_gain.glsl"

// One pipeline for tiles with foam, one without.
layout(constant_id = 4) const bool kFoaming = false;
layout(constant_id = 5) const bool kGain = false;

// Gain of a cascade's waves. What it adds to their slopes by its own is left out: its slope times the height.
float gainAt(vec2 p, uint cascade) { return kGain ? waveGain(gainMap, frame.waves.gain, p, cascade) : 1.0; }

struct SeaPoint {
  vec2 slope;        // mean, of the displaced surface
  vec3 normal;       // of that slope, level frame
  vec3 residual;     // covariance of the slopes about their mean: xx, zz, xz
  vec4 all;          // covariance of all the sea's slopes here; w: its reflectance seen from the horizon
  float compression; // how far the water is pushed together, -div D: near 1 at a crest about to break
  float lane;        // how far old foam gathers here, 0 ... 1
  float foam;        // mean freshness of the foam, 0 ... 1
};

// Of the foam of a freshness, what is breaking now and stays on its crest. The rest is old.
float breakingFoam(float freshness) { return freshness * smoothstep(0.5, 0.9, freshness); }

// A vector of the sea in the wind's frame: along it and across.
vec2 alongWind(vec2 p) {
  vec2 wind = frame.foam.zw;
  return vec2(dot(p, wind), dot(p, vec2(-wind.y, wind.x)));
}

// Where the wind gathers old foam, 0 ... 1, a half in the mean: lanes along it 4 and 16 m wide and eight times as long, as far
// as the footprint `side` [m] resolves them.
float foamLane(vec2 p, float side) {
  vec2 q = frame.foam.xy + alongWind(p);
  float wide = latticeNoise(q * vec2(1.0 / 128.0, 1.0 / 16.0), uvec2(8u, 32u)) - 0.5;
  float narrow = latticeNoise(q * vec2(1.0 / 32.0, 1.0 / 4.0), uvec2(32u, 128u)) - 0.5;
  return 0.5 + 0.6 * clamp(1.5 - side / 16.0, 0.0, 1.0) * wide + 0.4 * clamp(1.5 - side / 4.0, 0.0, 1.0) * narrow;
}

// Slope variance of short waves at a place per its mean: slicks and gusts in bands along the wind, 4, 16, 64, 256 and 1024 m wide and
// four times as long, as far as the footprint `side` [m] resolves them.
float slickVariance(vec2 p, float side) {
  const float kDeviation = 0.480;  // of the five octaves
  vec2 q = (frame.slicks.xy + alongWind(p)) * vec2(1.0 / 16.0, 1.0 / 4.0);
  uvec2 cells = uvec2(uint(kSlickPeriod) / 16u, uint(kSlickPeriod) / 4u);
  float width = 4.0, sum = 0.0;
  do {
    sum += clamp(1.5 - 2.0 * side / width, 0.0, 1.0) * (latticeNoise(q, cells) - 0.5);
    width *= 4.0;
    q = 0.25 * q + 17.3;
    cells >>= 2u;
  } while (width < 1100.0);
  return clamp(1.0 + frame.slicks.z / kDeviation * sum, 0.1, 1.9);
}

// Cascades of shorter patches [m] hold the waves that slicks calm, shorter than 1.5 m (kLongestWave).
const float kSlickPatch = 24.0;
float slickOn(uint cascade, float slick) { return frame.waves.placement[cascade].w < kSlickPatch ? slick : 1.0; }

// Freshness of a cascade's foam at a place in its patch. Far off, where a patch is seen many times over and the eye does not
// find the crest that broke, every patch has its foam elsewhere: few spots laid out alike would show what the warp hides.
float foamFreshness(uint cascade, vec2 uv, float side, float across) {
  vec4 placement = frame.waves.placement[cascade];
  float lod = waveLod(placement, float(frame.waves.size), side);
  float fresh = textureLod(foamMap, vec3(uv, float(cascade)), lod).r;
  float far = clamp(across * placement.x * kStrewnFootprint - 1.0, 0.0, 1.0);
  if (far > 0.0) {
    uvec2 patches = uvec2(ivec2(floor(uv)) + ivec2(frame.waves.patches[cascade].xy)) & (kPatchesApart - 1u);
    vec2 strewn = vec2(latticeValue(patches), latticeValue(patches + kPatchesApart));
    fresh = mix(fresh, textureLod(foamMap, vec3(uv + strewn, float(cascade)), lod).r, far);
  }
  return fresh;
}

// Where between two mips a lookup of the level `lod` blends: over the middle half of the way from one to the next, since
// devices read both only where they must.
float blendedLod(float lod) {
  float finer = floor(lod);
  return finer + clamp(2.0 * (lod - finer) - 0.5, 0.0, 1.0);
}

// By how much of its slopes' variance filtering between the texels of a cascade's mip smooths them.
float interpolationLoss(uint cascade, float mip) {
  uint i = uint(min(mip, 7.0));
  return frame.waves.interpolationLoss[2u * cascade + (i >> 2)][i & 3u];
}

// `p`: undisplaced place relative to the eye [m], seen with the footprint `side` of pixels `across` wide [m]. The first
// `cascades`, at least one, are sampled, of the others the variance counts; foam only from the cascades in the bit mask
// `foaming`, which is not 0 where kFoaming.
// Loops test at their end: software devices run a body that a loop's head has masked out.
SeaPoint seaPoint(vec2 p, float side, float across, uint cascades, uint foaming) {
  vec4 gradient = vec4(0);     // dh/dx, dh/dz, dDx/dx, dDz/dz
  vec4 moments = vec4(0);      // variances and covariance of the slopes, dDz/dx
  vec3 all = frame.slopes.xyz;  // of the whole sea, where gains are 1
  float foamFree = 1.0;
  float lane = 0.5;
  float endLod = log2(float(frame.waves.size) * kLongestWave);
  vec2 q = p + waveWarp(frame.waves.warp, p);
  float slick = slickVariance(p, side);
  uint c = 0u;
  do {
    vec4 placement = frame.waves.placement[c];
    float lod = waveLod(placement, float(frame.waves.size), side);
    vec3 place = vec3(waveUv(placement, q), float(c));
    // With the part w of the finer mip, of which the coarser is the mean, the slopes have the variance coarse +
    // w^2 (finer - coarse): the moments blend by w^2.
    float blended = blendedLod(lod);
    float finer = floor(blended);
    float w = 1.0 - (blended - finer);
    vec4 g = textureLod(gradientMap, place, blended);
    vec4 m = textureLod(momentsMap, place, finer + 1.0 - w * w);
    // Toward the end of what is resolved, all goes over into the expected variance. That of the sampled mean is less than
    // what is missing in m by what it was smoothed between the texels: of two mips w^2 and (1 - w)^2 of their own, and of
    // what they have in common, by quadrature, near half of the coarser's.
    float kept = clamp(endLod - lod, 0.0, 1.0);
    float power = kept * kept;
    float smoothed = w * w * interpolationLoss(c, finer) + (1.0 - w) * interpolationLoss(c, finer + 1.0);
    float lost = 1.0 - power + power * smoothed;
    // Shorter waves by the longer ones they ride on, which the Jacobian below shortens besides.
    float together = -(gradient.z + gradient.w);
    float variance = shortWaveVariance(together) * slickOn(c, slick);
    float shown = kept * sqrt(variance) * (1.0 - min(together, kMostPushedTogether));
    float gain = gainAt(p, c);
    gradient += gain * (shown * g);
    // Precise: the same with kGain and without.
    precise vec3 left = variance * (power * m.xyz + lost * frame.waves.slopeCovariance[c].xyz);
    moments += gain * vec4(gain * left, shown * m.w);
    if (kGain) all += (gain * gain - 1.0) * frame.waves.slopeCovariance[c].xyz;
  } while (++c < cascades);
  float variance = shortWaveVariance(-(gradient.z + gradient.w));
  for (; c < notWrittenIn(frame.waves.cascades); ++c) {
    float gain = gainAt(p, c);
    precise vec3 left = variance * slickOn(c, slick) * frame.waves.slopeCovariance[c].xyz;
    moments.xyz += gain * gain * left;
    if (kGain) all += (gain * gain - 1.0) * frame.waves.slopeCovariance[c].xyz;
  }
  if (kFoaming) {
    // Wind draws old foam out, and a strong one tears the edges of breaking crests. Where foam is looked up does not depend on
    // where the sea broke, so that the mean cover stays.
    vec2 drift = foamDrift() * frame.foam.zw;
    uint taps = notWrittenIn(frame.thinCrest.w > 0.0 ? 4u : 2u);
    if (taps > 2u) lane = foamLane(p, side);
    do {
      uint foamy = uint(findLSB(foaming));
      vec4 placement = frame.waves.placement[foamy];
      float texel = placement.w / float(frame.waves.size);
      vec2 torn = q + (texel * (2.0 * lane - 1.0) * frame.thinCrest.w) * frame.foam.zw;
      float fresh = breakingFoam(foamFreshness(foamy, waveUv(placement, torn), side, across));
      uint tap = 0u;
      do {
        float away = (2.0 * (float(tap) + lane)) / float(taps) - 1.0;
        float f = foamFreshness(foamy, waveUv(placement, q + away * drift), side, across);
        fresh += (f - breakingFoam(f)) / float(taps);
      } while (++tap < taps);
      fresh = min(fresh, 1.0);
      foamFree *= 1.0 - (kGain ? foamOfGain(fresh, gainAt(p, foamy), frame.waves.gain.w) : fresh);
      foaming &= foaming - 1u;
    } while (foaming != 0u);
  }

  SeaPoint sea;
  // Of h(q) over p + D(q) with q = p + w(p), whose derivatives are those over q times E = 1 + dw/dp: the slope s is what
  // solves (E^-T + dD/dq) s = dh/dq. The determinant is small or negative only where the surface folds over. The covariance
  // of what is left keeps to q: E is 1 in the mean.
  mat2 still = inverse(transpose(mat2(1.0) + waveWarpSlopes(frame.waves.warp, p)));
  mat2 stretch = still + mat2(gradient.z, moments.w, moments.w, gradient.w);
  float jacobian = max(determinant(stretch), 1.0 - kMostPushedTogether);
  sea.slope = vec2(stretch[1][1] * gradient.x - stretch[1][0] * gradient.y,
                   stretch[0][0] * gradient.y - stretch[0][1] * gradient.x) / jacobian;
  sea.slope *= min(1.0, 1.2 * inversesqrt(max(dot(sea.slope, sea.slope), 1e-8)));  // crests break before they are steeper
  sea.normal = normalize(vec3(-sea.slope.x, 1, -sea.slope.y));
  // Waves that no cascade holds are like the shortest that one does.
  float shortest = gainAt(p, frame.waves.cascades - 1u);
  precise vec3 tail = variance * slick * frame.waves.unresolved.xyz;
  sea.residual = moments.xyz + shortest * shortest * tail;
  if (kGain) all += (shortest * shortest - 1.0) * frame.waves.unresolved.xyz;
  sea.all = vec4(all, frame.slopes.w);
  sea.compression = -(gradient.z + gradient.w);
  sea.lane = lane;
  sea.foam = 1.0 - foamFree;
  return sea;
}

#endif
