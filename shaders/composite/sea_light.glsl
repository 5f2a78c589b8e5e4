// Light that comes from a point of the sea.
#ifndef PELAGIC_COMPOSITE_SEA_LIGHT_GLSL
#define PELAGIC_COMPOSITE_SEA_LIGHT_GLSL
#include "pelagic/shader/constants.h"
#include "physics/ocean_brdf.glsl"
#include "physics/optics.glsl"
#include "physics/panel.glsl"

// Of the facets seen: mean reflectance, and mean and variance of their facing, each counted by its reflectance.
vec3 reflectingFacets(float cosView, float deviation) {
  vec2 place = fresnelTablePlace(cosView, deviation);
  ivec2 low = min(ivec2(place), ivec2(kFresnelTableWidth - 2, kFresnelTableHeight - 2));
  vec2 f = place - vec2(low);
  int i = low.y * kFresnelTableWidth + low.x, j = i + kFresnelTableWidth;
  vec3 near = mix(texelFetch(fresnelTable, i).xyz, texelFetch(fresnelTable, i + 1).xyz, f.x);
  return mix(near, mix(texelFetch(fresnelTable, j).xyz, texelFetch(fresnelTable, j + 1).xyz, f.x), f.y);
}

// Place of a stereographic direction in the environment map; below the horizon, the horizon.
vec2 environmentPlace(vec2 s) {
  return 0.5 + 0.5 * kEnvironmentScale * s * min(1.0, inversesqrt(max(dot(s, s), 1e-8)));
}

// Mean radiance of the sky over what facets mirror whose slopes are Gaussian about that of `mirror`: two taps on the longer
// axis of the ellipse that they make in the map, of a blur as wide as the shorter one but not too round to meet, so that both
// together have the ellipse's second moments. Centres below the horizon move to its rim; the ellipse about them stays that of
// the unclamped place.
vec3 environment(Mirrored mirror, vec3 covariance) {
  vec2 u = environmentPlace(mirror.place);
  vec2 ux = 0.5 * kEnvironmentScale * mirror.alongX;
  vec2 uy = 0.5 * kEnvironmentScale * mirror.alongZ;
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
  float blur = max(minor, 0.6 * major);
  float lod = log2(max(1.3 * size * blur, 1.0));
  vec2 tap = sqrt(max(major * major - blur * blur, 0.0)) * axis;
  vec4 sum = textureLod(environmentMap, u - tap, lod) + textureLod(environmentMap, u + tap, lod);
  return sum.rgb / max(sum.a, 0.02);
}

// Radiance from below the surface, without what the surface keeps of it, where `entering` is the irradiance that enters.
// Behind a crest that is thin enough to be seen through stands the sky: its light goes into the near face and out of the far
// one, coloured by absorption on the way. How far the water is pushed together tells how thin a crest is; only crests seen
// against the light show it, since there the bright sky stands behind them.
vec3 bodyLight(SeaPoint sea, vec3 v, vec3 l, vec3 entering, vec3 behind) {
  float sharp = smoothstep(0.35, 0.95, sea.compression);
  float against = clamp(-dot(v.xz, l.xz) * inversesqrt(max(dot(v.xz, v.xz), 1e-6)), 0.0, 1.0);
  vec3 through = mix(frame.thickCrest.rgb, frame.thinCrest.rgb, sharp);
  float angle = acos(clamp(dot(v, sea.normal), 0.0, 1.0)) / (0.5 * kPi);
  vec3 albedo = mix(frame.waterAlbedo.rgb, frame.lookAlbedo.rgb, frame.lookAlbedo.w * angle);
  if (kFoaming) albedo += frame.slicks.w * plumeLeaving(frame.absorption.rgb, sea.foam);
  return albedo * entering * (1.0 - frame.crestsHide * sharp * against * through) + behind * (0.35 * sharp * against) * through;
}

// A light in the sky of a point: a disc of the angular radius `radius` [rad] around l, or a rectangle with the half-axes a and b
// over its distance, as in physics/panel.glsl. What it is not is 0.
struct Shining {
  vec3 l;
  float radius;
  vec3 a;
  vec3 b;
  vec3 irradiance;  // on a plane facing it
  vec3 radiance;
};

// What the sea mirrors of a light; no mirror is brighter than the light itself. `large`: it may be more than a point beside the
// sea's slopes, and then it is no brighter than its mirror image.
vec3 mirroredLight(SeaPoint sea, Visibility seen, vec3 v, Shining from, bool large) {
  vec2 mirror = mirrorSlope(v, from.l);
  vec3 h = normalize(v + from.l);
  float cosIncidence = max(dot(v, h), 0.0);
  vec3 extent = discCovariance(mirror, from.l, cosIncidence, from.radius);
  float reach = 0.0;
  if (large) {
    vec2 a = mirrorSlopeChange(mirror, v, from.l, from.a), b = mirrorSlopeChange(mirror, v, from.l, from.b);
    vec2 away = mirror - sea.slope;
    reach = discReach(extent, away) + abs(dot(a, away)) + abs(dot(b, away));
    extent += panelCovariance(a, b);
  }
  Visibility lit = visibility(from.l, sea.slope, sea.residual);
  float glint = sunReflection(seen, lit, v, mirror, sea.slope, sea.residual + extent);
  if (large) glint = min(glint, reflectionBound(seen, lit, v, mirror, sea.slope, sea.residual, reach));
  float fresnel = fresnelReflectance(cosIncidence, kWaterIndex);
  return min(from.irradiance * (glint * fresnel), from.radiance * (large ? fresnel : 1.0));
}

// Radiance of the sea without foam toward v; v and l in the level frame of the point. `sunlight`: irradiance of the sun on a
// plane facing it, `entering`: irradiance that enters the water besides its and the sky's, `horizon`: the sky's radiance at the
// horizon beyond the point.
vec3 seaRadiance(SeaPoint sea, vec3 v, vec3 l, vec3 sunlight, vec3 entering, vec3 horizon) {
  Visibility seen = visibility(v, sea.slope, sea.residual);
  entering += enteringIrradiance(sunlight, l.y, light.skyIrradiance.rgb);

  float perHorizontal = inversesqrt(max(dot(v.xz, v.xz), 1e-6));
  float deviation = seen.deviation * perHorizontal * sea.normal.y;
  vec3 facets = reflectingFacets(dot(v, sea.normal), deviation);
  float fresnel = facets.x;
  SeenSlopes mirrors = seenSlopes(seen, v, sea.residual, facets.y, facets.z);
  vec2 slope = sea.slope + mirrors.shift;
  vec3 sky = environment(mirroredBy(slope, v), mirrors.covariance);
  vec3 reflected = mix(frame.waterAlbedo.rgb * entering, sky, shareOfSky(slope, mirrors.covariance, v, sea.all));

  Shining disc = Shining(l, kSunAngularRadius, vec3(0), vec3(0), sunlight, light.sunRadiance.rgb);
  vec3 sun = mirroredLight(sea, seen, v, disc, false);
  return fresnel * frame.skyContrast * reflected + sun + (1.0 - fresnel) * bodyLight(sea, v, l, entering, horizon);
}

#endif
