// Foam: a dense core where a crest breaks, torn to lace and drawn out along the wind as it ages.
#ifndef PELAGIC_COMPOSITE_FOAM_GLSL
#define PELAGIC_COMPOSITE_FOAM_GLSL

// 0 ... 1 from a lattice point: Jarzynski & Olano (2020), pcg.
float latticeValue(uvec2 p) {
  uint state = (p.x * 1664525u + p.y * 22695477u + 1013904223u) * 747796405u + 2891336453u;
  uint word = (state >> ((state >> 28) + 4u) ^ state) * 277803737u;
  return float(word >> 8) * (1.0 / 16777216.0);
}

// Smooth noise, 0 ... 1, mean 1/2, of `cells` lattice cells before it repeats (a power of two).
float latticeNoise(vec2 p, uint cells) {
  vec2 base = floor(p);
  vec2 f = p - base;
  f = f * f * (3.0 - 2.0 * f);
  uvec2 i = uvec2(ivec2(base)) & (cells - 1u);
  uvec2 j = (i + 1u) & (cells - 1u);
  return mix(mix(latticeValue(i), latticeValue(uvec2(j.x, i.y)), f.x),
             mix(latticeValue(uvec2(i.x, j.y)), latticeValue(j), f.x), f.y);
}

// Height of the foam pattern, about 0 ... 1: ridges that close into cells, so that a high threshold leaves lace. What
// the footprint [m] cannot resolve fades to the mean.
float foamPattern(vec2 p, float footprint) {
  // Wind frame, drawn out along the wind.
  vec2 q = frame.foam.xy + vec2(dot(p, frame.foam.zw), dot(p, vec2(-frame.foam.w, frame.foam.z)));
  vec2 stretch = vec2(0.5, 1.0);
  float sum = 0.0;
  float weight = 0.5;
  for (uint octave = 0u; octave < 3u; ++octave) {
    float scale = float(1u << octave);  // cells per metre across the wind
    float n = latticeNoise(q * stretch * scale, uint(kFoamPeriod) << octave);
    float ridge = 1.0 - abs(2.0 * n - 1.0);
    float kept = clamp(1.5 - footprint * scale * 1.5, 0.0, 1.0);
    sum += weight * mix(0.62, ridge, kept);
    weight *= 0.6;
  }
  return sum / 0.98;
}

struct Foam {
  float cover;    // share of the pixel under foam
  float albedo;
};

Foam foamAt(float freshness, vec2 p, float footprint) {
  Foam foam;
  float fresh = clamp(freshness, 0.0, 1.0);
  float pattern = foamPattern(p, footprint);
  // Cover that shrinks faster than the freshness: 1 while breaking, lace after.
  float wanted = fresh * fresh;
  float soft = mix(0.08, 0.5, clamp(footprint, 0.0, 1.0));
  float threshold = 1.0 - wanted;
  foam.cover = wanted * smoothstep(threshold - soft, threshold + soft, pattern);
  foam.albedo = mix(0.45, 0.75, fresh);
  return foam;
}

#endif
