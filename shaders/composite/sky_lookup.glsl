// The sky as a camera sees it.
#ifndef PELAGIC_COMPOSITE_SKY_LOOKUP_GLSL
#define PELAGIC_COMPOSITE_SKY_LOOKUP_GLSL

const float kPi = 3.14159265;

// Place of the direction d (unit) in the radiance map.
vec2 skyPlace(vec3 d) {
  float edge = frame.thickCrest.w;
  float from = atan(d.y, length(d.xz)) - edge;
  float part = sqrt(abs(from) / (0.5 * kPi + (from < 0.0 ? edge : -edge)));
  // Not across the horizon: the first row's centre on either side.
  float row = max(part, 1.0 / float(textureSize(radianceMap, 0).y));
  // Straight up and down have no azimuth.
  float azimuth = dot(d.xz, d.xz) > 0.0 ? atan(d.z, d.x) : 0.0;
  return vec2(azimuth * (0.5 / kPi), 0.5 + 0.5 * (from < 0.0 ? -row : row));
}

// Radiance of the sky without the sun's disc; below the eye's horizon, that of the air (pelagic/sky.hpp).
vec3 skyRadiance(vec2 place) { return textureLod(radianceMap, place, 0.0).rgb; }

// Of the horizon at the same azimuth.
vec3 horizonRadiance(vec2 place) { return skyRadiance(vec2(place.x, 0.5 + 0.5 / float(textureSize(radianceMap, 0).y))); }

// Light of the clouds that a pixel shows, and the transmittance for what is behind them.
vec4 cloudsBefore(ivec2 pixel) {
  if (!kHasClouds) return vec4(0, 0, 0, 1);
  return textureLod(cloudPicture, (vec2(pixel) + 0.5) / (3.0 * vec2(textureSize(cloudPicture, 0))), 0.0);
}

// The sun's disc toward d with its limb darkening (1 - u (1 - mu), u = 0.6), of mean radiance light.sunRadiance; its edge
// is softened over a pixel of the angular size `pixel` [rad].
vec3 sunDisc(vec3 d, float pixel) {
  // A chord: near the sun a cosine has no digits left.
  float radius = acos(light.sunDirection.w);
  float from = distance(d, light.sunDirection.xyz);
  float coverage = clamp((radius - from) / pixel + 0.5, 0.0, 1.0);
  float inside = clamp(from / radius, 0.0, 1.0);
  float limb = (0.4 + 0.6 * sqrt(1.0 - inside * inside)) / 0.8;
  return light.sunRadiance.rgb * (coverage * limb);
}

#endif
