// The modes at a time. Include after "shared/waves.h", with `push.fractionHigh`, `push.fractionLow` and `push.share`.
#ifndef PELAGIC_WAVES_EVOLVE_GLSL
#define PELAGIC_WAVES_EVOLVE_GLSL

// Modes with an index in [kBand, N - kBand) along either axis are zero: neither evolved nor written.
layout(constant_id = 2) const uint kBand = 128;
// Whether one sea gives way to another. Otherwise only the first of the two is looked at.
layout(constant_id = 4) const bool kChanging = false;

// Two seas, one after the other: the one that comes, then the one that goes.
layout(set = 0, binding = 0) uniform samplerBuffer amplitudes;
layout(set = 0, binding = 1) uniform usamplerBuffer modes;

// Phase of `cycles` turns per loop [rad], from the high word of cycles x fraction.
float phase(uint cycles) {
  uint high, low;
  umulExtended(cycles, push.fractionLow, high, low);
  return float(int(cycles * push.fractionHigh + high)) * (kTwoPi / 4294967296.0);
}

// h(k) = h0(k) e^{-i w t} + conj h0(-k) e^{+i w t} in xy, chop times that in zw.
vec4 evolvedOne(int mode) {
  const vec4 amplitude = texelFetch(amplitudes, mode);
  const uvec3 constants = texelFetch(modes, mode).xyz;
  const vec2 w = unit(phase(constants.x));
  const vec2 h = vec2((amplitude.x + amplitude.z) * w.x + (amplitude.y - amplitude.w) * w.y,
                      (amplitude.y + amplitude.w) * w.x + (amplitude.z - amplitude.x) * w.y);
  return vec4(h, times(uintBitsToFloat(constants.yz), h));
}

vec4 evolved(int mode) {
  if (!kChanging) return evolvedOne(mode);
  return mix(evolvedOne(mode + textureSize(modes) / 2), evolvedOne(mode), push.share);
}

// Whether samples e N/16 ... (e + 1) N/16 of a line are not all zero.
bool inBand(uint e) { return e * FFT_THREADS < kBand || (e + 1) * FFT_THREADS > kSize - kBand; }

// Signed wave number of sample i of a line.
float waveNumber(uint i, float step) { return step * float(i < kSize / 2 ? int(i) : int(i) - int(kSize)); }

#endif
