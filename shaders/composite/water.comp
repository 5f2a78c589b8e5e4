#version 460
// Pixels of water: the sea's light and foam through the air.
#extension GL_GOOGLE_include_directive : require
#include "composite/bindings.glsl"
#include "composite/air.glsl"
#include "composite/edges.glsl"
#include "composite/sea_slopes.glsl"
#include "composite/tiles.glsl"
#include "composite/sea_light.glsl"
#include "composite/foam.glsl"
#include "physics/cloud_weather.glsl"

// Share of the sun's light that the clouds let through to the sea at p [m] from the eye; `side`: of the footprint [m]. An eye
// below clouds has its own weather all over the sea.
float sunThroughClouds(vec2 p, float side) {
  if (!kHasClouds) return 1.0;
  float lod = log2(max(side * light.cloudPlace.z * float(textureSize(cloudShadow, 0).x), 1.0));
  vec2 place = light.cloudPlace.xy + p * light.cloudPlace.z;
  vec2 shadow = textureLod(cloudShadow, place, lod).rg;
  if (!kVeiled) return mix(shadow.r, shadow.g, light.cloudZenith.w);
  vec2 above = cloudsTowardSun(place, light.sunDirection.xyz, light.cloudPlace.w, light.cloudSun.w, light.cloudPlace.z);
  return mix(shadow.r, shadow.g, cloudWeather(above));
}

// A direction in the level frame of a point that lies p [m] from the eye: the planet's curvature tilts the vertical by the
// angle whose sine is the length of p over the radius.
vec3 levelled(vec3 d, vec2 p) {
  vec2 tilt = p / frame.planetRadius;
  float cosine = sqrt(max(1.0 - dot(tilt, tilt), 0.0));
  float along = dot(d.xz, tilt);
  return vec3(d.xz - tilt * (d.y + along / (1.0 + cosine)), d.y * cosine + along).xzy;
}
#include "composite/host_lights.glsl"

// How far what a neighbouring pixel shows of the undisplaced sea lies from p along the unit vector `away` [m]; negative where
// it shows none.
float distanceToNeighbour(ivec2 pixel, vec2 p, vec2 away) {
  if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, ivec2(frame.width, frame.height)))) return -1.0;
  if (texelFetch(waterBody, pixel, 0).r == 0u) return -1.0;
  return abs(dot(texelFetch(waterPosition, pixel, 0).xy - p, away));
}

// Toward where the view rises fastest on screen, which leads away from the eye over the sea: unit length [px].
vec2 risingOnScreen(vec3 d) {
  vec2 rise = vec2(frame.rayX.y - d.y * dot(d, frame.rayX.xyz), frame.rayY.y - d.y * dot(d, frame.rayY.xyz));
  float squared = dot(rise, rise);
  return squared > 0.0 ? rise * inversesqrt(squared) : vec2(0, 1);
}

void main() {
  Tile tile = readTile(kVeiled ? kVeiledTiles : kFoaming ? kFoamTiles : kWaterTiles);
  if (!tile.valid) return;
  Pixel pixel = readPixel(tile.pixel);
  if (!pixel.water) return;  // sky.comp's
  vec3 ray = pixelRay(tile.pixel);
  float rayLength = length(ray);
  vec3 d = ray / rayLength;
  vec2 place = airPlace(d);
  float axial = axialDistance(pixel.waterDepth);
  vec2 p = texelFetch(waterPosition, tile.pixel, 0).xy;
  vec3 v = levelled(-d, p);
  vec3 l = levelled(light.sunDirection.xyz, p);
  // What a pixel covers of the undisplaced sea, from its neighbours away from the eye and toward it, however the camera is
  // rolled, as far as they are water; one of them may lie beyond a crest.
  float across = axial * frame.waterAlbedo.w;
  vec2 away = d.xz * inversesqrt(max(dot(d.xz, d.xz), 1e-8));
  vec2 rising = risingOnScreen(d);
  ivec2 neighbour = ivec2(round(rising));
  float a = distanceToNeighbour(tile.pixel - neighbour, p, away);
  float b = distanceToNeighbour(tile.pixel + neighbour, p, away);
  float along = (a < 0.0 || b < 0.0 ? max(a, b) : min(max(a, b), 3.0 * min(a, b))) / dot(vec2(neighbour), rising);
  float slant = across / max(along, across);
  float side = footprintSide(across, slant);
  SeaPoint sea = seaPoint(p, side, across, tile.cascades, tile.foaming);
  vec4 normal = vec4(sea.normal, 0);
  // What is seen of it; the slant tells how the sheet lies, neighbours being on the same cell mostly.
  float gain = gainAt(p, max(tile.cascades, 1u) - 1u);
  vec3 unseen = gain * gain * withoutRelief(side, across, max(v.y, frame.waves.unresolved.w / axial));
  sea.slope = facingSlope(sea.slope, v, slant, unseen);
  sea.normal = normalize(vec3(-sea.slope.x, 1, -sea.slope.y));
  vec3 sun = light.sunIrradiance.rgb * sunThroughClouds(p, side);
  // Foam lies on the sea itself, with a relief of its own.
  vec3 top = normal.xyz;
  Foam foam;
  if (kFoaming) {
    foam = foamAt(sea.foam, sea.lane, p, across, max(along, across) * away);
    top -= vec3(away.x, 0, away.y) * foam.slope.x + vec3(away.y, 0, -away.x) * foam.slope.y;
    normal.w = foam.cover;
  }
  HostLit lit = kNoHostLight;
  if (kHostLights) lit = hostLit(sea, normal.xyz, top, v, ray * axial, p);
  vec3 radiance = seaRadiance(sea, v, l, sun, lit.entering, horizonRadiance(place)) + lit.mirrored;
  if (kFoaming) {
    vec3 foamLight = sun * litFoam(normal.xyz, top, l) + light.skyIrradiance.rgb * (0.5 + 0.5 * normal.y) + lit.foam;
    radiance = mix(radiance, foamLight * (foam.shade * kFoamAlbedo / kPi), foam.cover * foam.opacity);
  }
  radiance = throughAir(radiance, place, axial * rayLength, 0.0);
  if (kVeiled) {
    vec4 clouds = cloudsBefore(tile.pixel);
    radiance = radiance * clouds.a + clouds.rgb;
  }

  writeRadiance(tile.pixel, radiance);
  if (kHasNormal) imageStore(normalImage, tile.pixel, normal);
  if (kHasSlopeVariance) imageStore(slopeVarianceImage, tile.pixel, vec4(sea.residual.xy, 0, 0));
  if (kHasMergedDepth) imageStore(mergedDepthImage, tile.pixel, vec4(pixel.depth));
}
