// How the cover of clouds varies over the sea. Compiles as GLSL and, through GLM, as C++.
#ifndef PELAGIC_PHYSICS_CLOUD_WEATHER_GLSL
#define PELAGIC_PHYSICS_CLOUD_WEATHER_GLSL
#include "physics/formula.h"

PELAGIC_PHYSICS_BEGIN

// Longest way through the layer that is followed, in thicknesses; what lies beyond is behind clouds or haze.
PELAGIC_FORMULA_CONSTANT float kCloudLongest = 20.0f;

// How far the weather holds clouds down, 0 ... 1: fields of them, 37 to 82 km apart, and more open sea between. None around the
// origin, so that a scene there has the cover that it asks for. `place` in tiles; repeats after kCloudWeatherTiles.
PELAGIC_FORMULA_CONSTANT float kCloudWeatherTiles = 12.0f;
// A wave of period 1 that is 1 at 0, as smooth as a cubic is: software devices call a library for each cosine.
PELAGIC_FORMULA float weatherWave(float turns) {
  float y = abs(2.0f * fract(turns) - 1.0f);
  return 2.0f * y * y * (3.0f - 2.0f * y) - 1.0f;
}
PELAGIC_FORMULA float cloudWeather(vec2 place) {
  vec2 p = place / kCloudWeatherTiles;
  float sum = weatherWave(p.x + 2.0f * p.y) + weatherWave(3.0f * p.x - p.y) + weatherWave(4.0f * p.x + 3.0f * p.y);
  return smoothstep(0.0f, 2.0f, 1.2f - sum);
}

// Where the sun's light on a place at sea level comes through the middle of the layer from `base` to `top` [m].
PELAGIC_FORMULA vec2 cloudsTowardSun(vec2 place, vec3 sun, float base, float top, float tilesPerMetre) {
  return place + vec2(sun.x, sun.z) * (0.5f * (base + top) * tilesPerMetre / max(sun.y, 1.0f / kCloudLongest));
}

PELAGIC_PHYSICS_END
#endif
