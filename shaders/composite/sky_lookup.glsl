// The sky as a camera sees it.
#ifndef PELAGIC_COMPOSITE_SKY_LOOKUP_GLSL
#define PELAGIC_COMPOSITE_SKY_LOOKUP_GLSL

#include "pelagic/shader/constants.h"
#include "physics/moon.glsl"
#include "physics/noise.glsl"
#include "shared/sky_pass.h"

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

// Light of the clouds that a pixel shows, and the transmittance for what is behind them. Their picture is coarser: a cubic
// filter between its pixels, a compromise of blur and ringing (Mitchell & Netravali 1988, B = C = 1/3), as five bilinear samples;
// the corners' weights are left out, and what its negative lobes make is clamped.
vec4 cloudsBefore(ivec2 pixel) {
  if (!kHasClouds) return vec4(0, 0, 0, 1);
  vec2 size = vec2(textureSize(cloudPicture, 0));
  vec2 at = (vec2(pixel) + 0.5) / float(kCloudPixels) - 0.5;
  vec2 f = fract(at), low = floor(at) + 0.5;
  vec2 g = 1.0 - f;
  vec2 first = 1.0 / 18.0 + f * (f * (15.0 - 7.0 * f) - 9.0) / 18.0, last = 1.0 / 18.0 + g * (g * (15.0 - 7.0 * g) - 9.0) / 18.0;
  vec2 third = 8.0 / 9.0 - g * g * (12.0 - 7.0 * g) / 6.0;
  vec2 inner = 1.0 - first - last;
  vec2 middle = (low + third / inner) / size, before = (low - 1.0) / size, after = (low + 2.0) / size;
  vec4 sum = inner.x * inner.y * textureLod(cloudPicture, middle, 0.0);
  sum += inner.x * first.y * textureLod(cloudPicture, vec2(middle.x, before.y), 0.0);
  sum += inner.x * last.y * textureLod(cloudPicture, vec2(middle.x, after.y), 0.0);
  sum += first.x * inner.y * textureLod(cloudPicture, vec2(before.x, middle.y), 0.0);
  sum += last.x * inner.y * textureLod(cloudPicture, vec2(after.x, middle.y), 0.0);
  float whole = 1.0 - (first.x + last.x) * (first.y + last.y);
  return clamp(sum / whole, vec4(0), vec4(vec3(kLargestRadiance), 1));
}

// Share that a pixel of the angular size `pixel` [rad] has of a disc of the angular radius `radius` around `centre`. The disc is
// ten thousand times as bright as the sky beside it: an edge a pixel wide would show as steps, so that it falls off as from a
// lens, to a tenth in a pixel. Scaled so that the whole disc keeps its light. A chord: near it a cosine has no digits left.
float discCoverage(vec3 d, vec3 centre, float radius, float pixel) {
  float spread = 0.43 * pixel;
  // The integral over the plane per the disc's area: a Fermi function's, with the dilogarithm of -e by its series.
  float e = exp(-radius / spread);
  float dilogarithm = -e * (1.0 - e * (1.0 / 4.0 - e * (1.0 / 9.0 - e / 16.0)));
  float whole = 1.0 + 2.0 * (kPi * kPi / 6.0 + dilogarithm) * spread * spread / (radius * radius);
  return 1.0 / ((1.0 + exp(min((distance(d, centre) - radius) / spread, 80.0))) * whole);
}

// The sun's disc toward d with its limb darkening (1 - u (1 - mu), u = 0.6), of mean radiance light.sunRadiance.
vec3 sunDisc(vec3 d, float pixel) {
  float radius = acos(light.sunDirection.w);
  float inside = distance(d, light.sunDirection.xyz) / radius;
  // What the rim's falling off takes inside it, the same outside gives back; far outside it is the disc's mean, 1.
  float limb = (0.4 + 0.6 * sqrt(abs(1.0 - min(inside * inside, 13.0 / 9.0)))) / 0.8;
  return light.sunRadiance.rgb * (light.sunRadiance.w * discCoverage(d, light.sunDirection.xyz, radius, pixel) * limb);
}

// The moon's disc, of which the side toward the sun is lit; that is evenly bright, as the moon is.
vec3 moonDisc(vec3 d, float pixel) {
  vec3 moon = light.moonDirection.xyz;
  vec3 across = (d - moon) / kSunAngularRadius;
  across *= min(1.0, 0.99 * inversesqrt(max(dot(across, across), 1e-8)));  // what the lens spreads over the rim is from within
  vec3 normal = across - moon * sqrt(max(1.0 - dot(across, across), 0.0));
  float lit = smoothstep(-0.05, 0.1, dot(normal, light.moonLit.xyz));
  return light.moonRadiance.rgb * (discCoverage(d, moon, kSunAngularRadius, pixel) * lit);
}

// The stars toward d: one in each cell of a cube's faces, spread over the pixels around it.
vec3 starLight(vec3 d, float pixel) {
  const float kCells = 128.0, kStars = 6.0 * kCells * kCells;
  vec4 turn = light.stars;
  vec3 q = d + 2.0 * cross(turn.xyz, cross(turn.xyz, d) + turn.w * d);
  vec3 size = abs(q);
  uint face = size.x > max(size.y, size.z) ? 0u : size.y > size.z ? 1u : 2u;
  vec3 f = face == 0u ? q : face == 1u ? q.yzx : q.zxy;
  vec2 place = (0.5 + 0.5 * f.yz / abs(f.x)) * kCells;
  uvec2 cell = min(uvec2(place), uvec2(uint(kCells) - 1u));
  uint row = cell.y + uint(kCells) * (2u * face + (f.x > 0.0 ? 1u : 0u));
  // Not so near the cell's border that its neighbour would have to show it.
  vec2 at = vec2(cell) + 0.25 + 0.5 * vec2(latticeValue(uvec2(cell.x, row)), latticeValue(uvec2(cell.x + 128u, row)));
  vec3 star = normalize(vec3(sign(f.x), 2.0 * at / kCells - 1.0));
  float magnitude = starMagnitude(latticeValue(uvec2(cell.x + 256u, row)), kStars);
  float spread = 1.3 * pixel;
  float near = max(1.0 - distance(star, normalize(f)) / spread, 0.0);
  float warm = latticeValue(uvec2(cell.x + 384u, row));
  vec3 tint = mix(vec3(0.8, 0.95, 1.3), vec3(1.25, 0.97, 0.7), warm);
  // The spread's square integrates to pi/6 of its radius' square.
  // The air takes what it does over a flat Earth, less at the horizon.
  vec3 air = light.rayleighExtinction.rgb * light.rayleighExtinction.w + light.mieExtinction.rgb * light.mieExtinction.w;
  vec3 shown = tint * exp(-air / max(d.y, 0.03)) * (light.skyIrradiance.w * light.moonDirection.w);
  return shown * (starStrength(magnitude) * near * near * 6.0 / (kPi * spread * spread));
}

#endif
