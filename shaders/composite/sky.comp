#version 460
// Pixels without water: the sky, or the host's picture where it is nearer than the far plane.
#extension GL_GOOGLE_include_directive : require
#include "composite/bindings.glsl"
#include "composite/air.glsl"
#include "composite/edges.glsl"
#include "composite/tiles.glsl"

void main() {
  Tile tile = readTile(kNight ? kNightTiles : kSkyTiles);
  if (!tile.valid) return;
  Pixel pixel = readPixel(tile.pixel);
  if (pixel.water) return;  // water.comp's
  vec3 ray = pixelRay(tile.pixel);
  float inverseLength = inversesqrt(dot(ray, ray));
  vec3 d = ray * inverseLength;
  vec4 clouds = cloudsBefore(tile.pixel);
  float pixelSize = frame.waterAlbedo.w * inverseLength;
  vec3 radiance = skyRadiance(skyPlace(d)) + sunDisc(d, pixelSize);
  if (kNight) {
    radiance += moonDisc(d, pixelSize);
    if (notWrittenIn(uint(light.skyIrradiance.w > 1.0)) > 0u) radiance += starLight(d, pixelSize);
  }
  radiance = radiance * clouds.a + clouds.rgb;
  if (kHasHost && pixel.host) {
    radiance = texelFetch(hostColor, tile.pixel, 0).rgb;
    if (kAirBeforeHost) {
      vec3 place = ray * axialDistance(pixel.depth);
      float height = max(heightOverSea(place), 0.0);
      vec4 before = cloudsBefore(tile.pixel, height);
      radiance = throughAir(radiance, airPlace(d), length(place), height) * before.a + before.rgb;
    }
  }
  writeRadiance(tile.pixel, radiance);
  if (kHasNormal) imageStore(normalImage, tile.pixel, vec4(0));
  if (kHasSlopeVariance) imageStore(slopeVarianceImage, tile.pixel, vec4(0));
  if (kHasMergedDepth) imageStore(mergedDepthImage, tile.pixel, vec4(pixel.depth));
}
