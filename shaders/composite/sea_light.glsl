// Light that comes from a point of the sea.
#ifndef PELAGIC_COMPOSITE_SEA_LIGHT_GLSL
#define PELAGIC_COMPOSITE_SEA_LIGHT_GLSL
#include "pelagic/shader/constants.h"
#include "physics/ocean_brdf.glsl"
#include "physics/optics.glsl"

float meanFresnel(float cosView, float deviation) {
  vec2 place = fresnelTablePlace(cosView, deviation);
  ivec2 low = min(ivec2(place), ivec2(kFresnelTableWidth - 2, kFresnelTableHeight - 2));
  vec2 f = place - vec2(low);
  int i = low.y * kFresnelTableWidth + low.x;
  return mix(mix(fresnelTable[i], fresnelTable[i + 1], f.x),
             mix(fresnelTable[i + kFresnelTableWidth], fresnelTable[i + kFresnelTableWidth + 1], f.x), f.y);
}

// The direction in which a facet of the slope s shows v, as a place in the environment map: the mirrored ray is
// r = 2 q m / M - v with m = (-s.x, 1, -s.y), q = m.v and M = m.m, so that its stereographic place r.xz / (1 + r.y) and
// the derivatives are ratios of polynomials.
struct Mirrored {
  vec2 place;
  vec2 alongX;      // d place / d s.x
  vec2 alongZ;      // d place / d s.y
  float elevation;  // r.y
};

Mirrored mirrored(vec3 v, vec2 s) {
  float q = v.y - dot(v.xz, s);
  float m = 1.0 + dot(s, s);
  float b = max(2.0 * q + m * (1.0 - v.y), 0.05 * m);
  vec2 u = (-2.0 * q * s - m * v.xz) / b;
  float scale = 0.5 * kEnvironmentScale;
  Mirrored result;
  // Below the horizon, the horizon.
  result.place = 0.5 + scale * u * min(1.0, inversesqrt(max(dot(u, u), 1e-8)));
  vec2 slant = s * (1.0 - v.y) - v.xz;  // half of db / ds
  float factor = 2.0 * scale / b;
  result.alongX = factor * (v.x * s - s.x * v.xz - vec2(q, 0) - slant.x * u);
  result.alongZ = factor * (v.z * s - s.y * v.xz - vec2(0, q) - slant.y * u);
  result.elevation = 2.0 * q / m - v.y;
  return result;
}

// Mean radiance of the sky over what a Gaussian of slopes about the mirror's mirrors: two taps along the longer axis of the ellipse that two
// standard deviations make in the map.
vec3 environment(Mirrored mirror, vec3 covariance) {
  vec2 ux = mirror.alongX;
  vec2 uy = mirror.alongZ;
  // J C J', the covariance in the map.
  vec2 cx = covariance.x * ux + covariance.z * uy;
  vec2 cy = covariance.z * ux + covariance.y * uy;
  float xx = cx.x * ux.x + cy.x * uy.x;
  float yy = cx.y * ux.y + cy.y * uy.y;
  float xy = cx.x * ux.y + cy.x * uy.y;
  float centre = 0.5 * (xx + yy);
  float spread = sqrt(max(0.25 * (xx - yy) * (xx - yy) + xy * xy, 0.0));
  float major = sqrt(centre + spread);
  float minor = sqrt(max(centre - spread, 0.0));
  vec2 axis = abs(xy) > 1e-12 ? normalize(vec2(xy, centre + spread - xx)) : (xx > yy ? vec2(1, 0) : vec2(0, 1));
  float size = float(textureSize(environmentMap, 0).x);
  float lod = log2(max(2.0 * size * max(minor, 0.6 * major), 1.0));
  vec4 sum = textureLod(environmentMap, mirror.place - 0.75 * major * axis, lod) +
             textureLod(environmentMap, mirror.place + 0.75 * major * axis, lod);
  return sum.rgb / max(sum.a, 0.02);
}

// Light of the sky behind a crest that is thin enough to be seen through: into the near face and out of the far one,
// coloured by absorption on the way. How far the water is pushed together tells how thin a crest is; only crests seen
// against the light show it, since there the bright sky stands behind them.
vec3 crestLight(SeaPoint sea, vec3 v, vec3 l, vec3 behind) {
  float sharp = smoothstep(0.35, 0.95, sea.compression);
  float against = clamp(-dot(v.xz, l.xz) * inversesqrt(max(dot(v.xz, v.xz), 1e-6)), 0.0, 1.0);
  return behind * (0.35 * sharp * against) * mix(frame.thickCrest.rgb, frame.thinCrest.rgb, sharp);
}

// Radiance of the sea without foam toward v; v and l in the level frame of the point. `horizon`: the sky's radiance at the
// horizon beyond the point.
vec3 seaRadiance(SeaPoint sea, vec3 v, vec3 l, vec3 horizon) {
  Visibility seen = visibility(v, sea.slope, sea.residual);
  vec3 under = frame.waterAlbedo.rgb * enteringIrradiance(light.sunIrradiance.rgb, light.sunDirection.y,
                                                          light.skyIrradiance.rgb);

  float deviation = seen.deviation * inversesqrt(max(dot(v.xz, v.xz), 1e-6)) * sea.normal.y;
  float fresnel = meanFresnel(dot(v, sea.normal), deviation);
  vec2 slope = sea.slope + visibleShift(seen, v, sea.residual);
  vec3 covariance = visibleCovariance(seen, v, sea.residual);
  Mirrored centre = mirrored(v, slope);
  vec3 sky = environment(centre, covariance);
  // Part of the facets mirror what lies below the horizon, which is sea: the sky once more, mirrored at grazing incidence.
  float spread = 2.0 * sqrt(max(covarianceAlong(covariance, v.xz * inversesqrt(max(dot(v.xz, v.xz), 1e-6))), 1e-8));
  float above = 1.0 / (1.0 + exp(-1.702 * clamp(centre.elevation / spread, -20.0, 20.0)));
  vec3 reflected = mix(0.5 * (sky + under), sky, above);

  vec2 mirror = mirrorSlope(v, l);
  vec3 h = normalize(v + l);
  float cosIncidence = max(dot(v, h), 0.0);
  vec3 wide = sea.residual + discCovariance(mirror, l, cosIncidence, kSunAngularRadius);
  Visibility lit = visibility(l, sea.slope, sea.residual);
  float glint = sunReflection(seen, lit, mirror, sea.slope, wide) * fresnelReflectance(cosIncidence, kWaterIndex);
  // No mirror is brighter than the sun.
  vec3 sun = min(light.sunIrradiance.rgb * glint, light.sunRadiance.rgb);

  return fresnel * reflected + sun + (1.0 - fresnel) * (under + crestLight(sea, v, l, horizon));
}

#endif
