// Looks the sea up in the wave maps. Include after wave_sampling.h.
// p: point of the undisplaced plane relative to the origin given to pelagic::waveSampling() [m].
#ifndef PELAGIC_SHADER_WAVE_LOOKUP_GLSL
#define PELAGIC_SHADER_WAVE_LOOKUP_GLSL

// Turns of the warp's waves, less the nearest whole number.
vec4 waveWarpTurns(WaveWarp warp, int group, vec2 p) {
  vec4 turns = warp.phase[group] + warp.alongX[group] * p.x + warp.alongZ[group] * p.y;
  return turns - floor(turns + 0.5);
}

// How far from p its water lies in every patch [m], so that no two places far from each other see the same waves; but for
// what it is at the world's origin, which is taken off the texture coordinate of the placement. The waves are parabolas,
// 8 t (1 - 2 |t|), as smooth as is needed and the same to the last digits everywhere.
vec2 waveWarp(WaveWarp warp, vec2 p) {
  vec2 shift = vec2(0);
  for (int i = 0; i < 2; ++i) {
    vec4 t = waveWarpTurns(warp, i, p);
    vec4 wave = t * (8.0 - 16.0 * abs(t));
    shift += vec2(dot(wave, warp.shiftX[i]), dot(wave, warp.shiftZ[i]));
  }
  return shift;
}

// Its derivatives [1]: column 0 along x, column 1 along z.
mat2 waveWarpSlopes(WaveWarp warp, vec2 p) {
  mat2 slopes = mat2(0);
  for (int i = 0; i < 2; ++i) {
    vec4 rate = 8.0 - 32.0 * abs(waveWarpTurns(warp, i, p));
    vec4 x = rate * warp.alongX[i];
    vec4 z = rate * warp.alongZ[i];
    slopes += mat2(dot(x, warp.shiftX[i]), dot(x, warp.shiftZ[i]), dot(z, warp.shiftX[i]), dot(z, warp.shiftZ[i]));
  }
  return slopes;
}

// Texture coordinate of q = p + waveWarp(warp, p).
vec2 waveUv(vec4 placement, vec2 q) { return q * placement.x + placement.yz; }

// Mip level whose texels have the length `footprint` [m]; not clamped above.
float waveLod(vec4 placement, float size, float footprint) {
  return log2(max(footprint * placement.x * size, 1.0));
}

#endif
