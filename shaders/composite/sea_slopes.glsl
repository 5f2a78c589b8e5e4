// The sea within a pixel: mean slope, the covariance of what the pixel cannot resolve, and foam.
#ifndef PELAGIC_COMPOSITE_SEA_SLOPES_GLSL
#define PELAGIC_COMPOSITE_SEA_SLOPES_GLSL
#include "composite/footprint.glsl"
#include "pelagic/shader/wave_lookup.glsl"

struct SeaPoint {
  vec2 slope;        // mean, of the displaced surface
  vec3 normal;       // of that slope, level frame
  vec3 residual;     // covariance of the slopes about their mean: xx, zz, xz
  float compression; // how far the water is pushed together, -div D: near 1 at a crest about to break
  float foam;        // mean freshness of the foam, 0 ... 1
};

// The pixel's ellipse on the still water: `across` [m] wide and `along` [m] deep in the direction `axis`. The maps' mips
// are square, so two taps half the depth apart share the work, and what differs between them is variance too.
struct Footprint {
  vec2 axis;
  float across;
  float along;
  float sampled;  // side of the square that one tap averages [m]
  vec2 tap;       // offset of the taps [m]
};

// Facets that a grazing view sees lean toward it: a pixel is never deeper than its width over this slope.
const float kSteepestView = 0.04;

Footprint footprintOf(vec3 v, float across) {
  Footprint f;
  f.axis = v.xz * inversesqrt(max(dot(v.xz, v.xz), 1e-8));
  f.across = across;
  f.along = across / max(v.y, kSteepestView);
  f.sampled = clamp(0.5 * f.along, across, 4.0 * across);
  f.tap = f.axis * (0.25 * max(f.along - across, 0.0));
  return f;
}

vec3 outer(vec2 a) { return vec3(a.x * a.x, a.y * a.y, a.x * a.y); }

// `p`: undisplaced place relative to the eye [m]. Only the first `cascades` are sampled, of the others the variance counts.
SeaPoint seaPoint(vec2 p, Footprint f, uint cascades) {
  vec4 gradient = vec4(0);     // dh/dx, dh/dz, dDx/dx, dDz/dz
  vec4 moments = vec4(0);      // variances and covariance of the slopes, dDz/dx
  float foamFree = 1.0;
  float endLod = log2(float(frame.waves.size) * kLongestWave);
  for (uint c = 0u; c < cascades; ++c) {
    vec4 placement = frame.waves.placement[c];
    float lod = waveLod(placement, float(frame.waves.size), f.sampled);
    vec2 uv = waveUv(placement, p);
    vec2 tap = f.tap * placement.x;
    vec4 a = textureLod(gradientMap, vec3(uv - tap, float(c)), lod);
    vec4 b = textureLod(gradientMap, vec3(uv + tap, float(c)), lod);
    vec4 m = textureLod(momentsMap, vec3(uv, float(c)), lod);
    // Toward the end of what is resolved, all goes over into the expected variance.
    float kept = clamp(endLod - lod, 0.0, 1.0);
    m.xyz = mix(frame.waves.slopeCovariance[c].xyz, m.xyz + outer(0.5 * (a.xy - b.xy)), kept);
    gradient += 0.5 * kept * (a + b);
    moments += vec4(m.xyz, kept * m.w);
    foamFree *= 1.0 - textureLod(foamMap, vec3(uv, float(c)), lod).r;
  }
  for (uint c = cascades; c < frame.waves.cascades; ++c) {
    moments.xyz += frame.waves.slopeCovariance[c].xyz;
    foamFree *= 1.0 - textureLod(foamMap, vec3(0.5, 0.5, float(c)), frame.waves.maxLod).r;
  }

  SeaPoint sea;
  // P_z x P_x with P_x = (1 + dDx/dx, dh/dx, dDz/dx), P_z = (dDz/dx, dh/dz, 1 + dDz/dz); its y is the Jacobian, which is
  // small or negative only where the surface folds over.
  float xx = 1.0 + gradient.z;
  float zz = 1.0 + gradient.w;
  float xz = moments.w;
  float jacobian = max(xx * zz - xz * xz, 0.15);
  sea.slope = vec2(zz * gradient.x - xz * gradient.y, xx * gradient.y - xz * gradient.x) / jacobian;
  sea.slope *= min(1.0, 1.2 * inversesqrt(max(dot(sea.slope, sea.slope), 1e-8)));  // crests break before they are steeper
  sea.normal = normalize(vec3(-sea.slope.x, 1, -sea.slope.y));
  sea.residual = moments.xyz + frame.waves.unresolved.xyz;
  sea.compression = -(gradient.z + gradient.w);
  sea.foam = 1.0 - foamFree;
  return sea;
}

#endif
