// Looks the gain of a cascade's waves up, where the simulation has a map of it (pelagic::GainMap). Include after
// wave_sampling.h. The same numbers as on the CPU: filtering hardware weighs by 8 bits only.
#ifndef PELAGIC_SHADER_WAVE_GAIN_GLSL
#define PELAGIC_SHADER_WAVE_GAIN_GLSL

// `gain`: WaveSampling::gain; `p`: point of the undisplaced plane relative to the origin given to pelagic::waveSampling().
float waveGain(sampler2DArray map, vec4 gain, vec2 p, uint cascade) {
  ivec2 last = textureSize(map, 0).xy - 1;
  vec2 at = clamp(p * gain.x + gain.yz, vec2(0), vec2(last));
  ivec2 cell = min(ivec2(at), last - 1);
  vec2 f = at - vec2(cell);
  ivec3 i = ivec3(cell, int(cascade));
  float near = mix(texelFetch(map, i, 0).r, texelFetch(map, i + ivec3(1, 0, 0), 0).r, f.x);
  float far = mix(texelFetch(map, i + ivec3(0, 1, 0), 0).r, texelFetch(map, i + ivec3(1, 1, 0), 0).r, f.x);
  return mix(near, far, f.y);
}

// Freshness of foam where its waves have a gain: how much of the sea breaks falls as exp(-w (1/gain^2 - 1)), the tail of
// the normal distribution. Less foam is younger foam, the last of it the cores; more of it is denser.
float foamOfGain(float freshness, float gain, float w) {
  float share = exp(-w * (1.0 / max(gain * gain, 1e-4) - 1.0));
  return share < 1.0 ? max(0.0, 1.0 - (1.0 - freshness) / max(share, 1e-6)) : min(1.0, freshness * share);
}

#endif
