// Looks the sea up in the wave maps. Include after wave_sampling.h.
// p: point of the undisplaced plane relative to the origin given to pelagic::waveSampling() [m].
#ifndef PELAGIC_SHADER_WAVE_LOOKUP_GLSL
#define PELAGIC_SHADER_WAVE_LOOKUP_GLSL

vec2 waveUv(vec4 placement, vec2 p) { return p * placement.x + placement.yz; }

// Mip level whose texels have the length `footprint` [m]; not clamped above.
float waveLod(vec4 placement, float size, float footprint) {
  return log2(max(footprint * placement.x * size, 1.0));
}

#endif
