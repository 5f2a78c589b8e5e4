// Random numbers on a lattice, and smooth noise between them.
#ifndef PELAGIC_PHYSICS_NOISE_GLSL
#define PELAGIC_PHYSICS_NOISE_GLSL

// 0 ... 1 from a lattice point: Jarzynski & Olano (2020), pcg.
float latticeValue(uvec2 p) {
  uint state = (p.x * 1664525u + p.y * 22695477u + 1013904223u) * 747796405u + 2891336453u;
  uint word = (state >> ((state >> 28) + 4u) ^ state) * 277803737u;
  return float(word >> 8) * (1.0 / 16777216.0);
}

// Smooth noise, 0 ... 1, mean 1/2, that repeats after `cells` (powers of two) lattice cells.
float latticeNoise(vec2 p, uvec2 cells) {
  vec2 base = floor(p);
  vec2 f = p - base;
  f = f * f * (3.0 - 2.0 * f);
  uvec2 i = uvec2(ivec2(base)) & (cells - 1u);
  uvec2 j = (i + 1u) & (cells - 1u);
  return mix(mix(latticeValue(i), latticeValue(uvec2(j.x, i.y)), f.x),
             mix(latticeValue(uvec2(i.x, j.y)), latticeValue(j), f.x), f.y);
}

float latticeValue(uvec3 p) { return latticeValue(uvec2(p.x + p.z * 2654435769u, p.y ^ (p.z * 668265263u))); }

// The same in three dimensions; repeats along x and y only.
float latticeNoise(vec3 p, uvec2 cells) {
  vec3 base = floor(p);
  vec3 f = p - base;
  f = f * f * (3.0 - 2.0 * f);
  uvec3 i = uvec3(ivec3(base));
  i.xy &= cells - 1u;
  uvec2 j = (i.xy + 1u) & (cells - 1u);
  float floors[2];
  for (uint k = 0u; k < 2u; ++k) {
    uint z = i.z + k;
    floors[k] = mix(mix(latticeValue(uvec3(i.x, i.y, z)), latticeValue(uvec3(j.x, i.y, z)), f.x),
                    mix(latticeValue(uvec3(i.x, j.y, z)), latticeValue(uvec3(j.x, j.y, z)), f.x), f.y);
  }
  return mix(floors[0], floors[1], f.z);
}

#endif
