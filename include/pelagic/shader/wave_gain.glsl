// Looks the gain of a cascade's waves up, where the simulation has a map of it (pelagic::GainMap). Include after
// wave_sampling.h. The same numbers as on the CPU: filtering hardware weighs by 8 bits only.
#ifndef PELAGIC_SHADER_WAVE_GAIN_GLSL
#define PELAGIC_SHADER_WAVE_GAIN_GLSL

// Gain at a place in samples, and its slope along x and z per sample; beyond the map that of its edge.
vec3 waveGainAt(sampler2DArray map, vec2 place, uint cascade) {
  ivec2 last = textureSize(map, 0).xy - 1;
  vec2 at = clamp(place, vec2(0), vec2(last));
  ivec2 cell = min(ivec2(at), last - 1);
  vec2 f = at - vec2(cell);
  ivec3 i = ivec3(cell, int(cascade));
  float a = texelFetch(map, i, 0).r, b = texelFetch(map, i + ivec3(1, 0, 0), 0).r;
  float c = texelFetch(map, i + ivec3(0, 1, 0), 0).r, d = texelFetch(map, i + ivec3(1, 1, 0), 0).r;
  vec2 inside = vec2(equal(place, at));
  return vec3(mix(mix(a, b, f.x), mix(c, d, f.x), f.y), inside * vec2(mix(b - a, d - c, f.y), mix(c - a, d - b, f.x)));
}

// `gain`: WaveSampling::gain; `p`: point of the undisplaced plane relative to the origin given to pelagic::waveSampling().
float waveGain(sampler2DArray map, vec4 gain, vec2 p, uint cascade) {
  return waveGainAt(map, p * gain.x + gain.yz, cascade).x;
}

// Freshness of foam where its waves have a gain: how much of the sea breaks falls as exp(-w (1/gain^2 - 1)), the tail of
// the normal distribution. Less foam is younger foam, the last of it the cores; more of it is denser.
float foamOfGain(float freshness, float gain, float w) {
  float share = exp(-w * (1.0 / max(gain * gain, 1e-4) - 1.0));
  // What breaks this very moment has an age too, or it would go on breaking where there are no waves.
  float age = max(1.0 - freshness, 1e-3);
  return share < 1.0 ? max(0.0, 1.0 - age / max(share, 1e-6)) : min(1.0, freshness * share);
}

#endif
