// The sky as a camera sees it.
#ifndef PELAGIC_COMPOSITE_SKY_LOOKUP_GLSL
#define PELAGIC_COMPOSITE_SKY_LOOKUP_GLSL

const float kPi = 3.14159265;

// Radiance of the sky without the sun's disc toward d (unit). Below the horizontal there is the horizon's: what a high
// camera sees between the horizontal and the dipped edge of the sea.
vec3 skyRadiance(vec3 d) {
  float elevation = max(atan(d.y, length(d.xz)), 0.0);
  float rows = float(textureSize(radianceMap, 0).y);
  // Not below the centre of the first row above the horizon, lest the filter mixes in the rows under it.
  float v = 0.5 + 0.5 * max(sqrt(elevation * (2.0 / kPi)), 1.0 / rows);
  // Straight up and down have no azimuth.
  float azimuth = dot(d.xz, d.xz) > 0.0 ? atan(d.z, d.x) : 0.0;
  return textureLod(radianceMap, vec2(azimuth * (0.5 / kPi), v), 0.0).rgb;
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
