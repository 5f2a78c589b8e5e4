// Bindings of the composite passes, the same in each. What a view lacks is bound to something else and never touched.
#ifndef PELAGIC_COMPOSITE_BINDINGS_GLSL
#define PELAGIC_COMPOSITE_BINDINGS_GLSL
#include "shared/composite.h"
#include "pelagic/shader/sky_light.h"

layout(constant_id = 0) const bool kHasHost = false;
layout(constant_id = 1) const bool kHasNormal = false;
layout(constant_id = 2) const bool kHasSlopeVariance = false;
layout(constant_id = 3) const bool kHasMergedDepth = false;
layout(constant_id = 6) const bool kHasClouds = false;
// Of the pipelines for kNightTiles and kVeiledTiles.
layout(constant_id = 7) const bool kNight = false;
layout(constant_id = 8) const bool kVeiled = false;
layout(constant_id = 10) const bool kAirBeforeHost = true;

layout(binding = 0, std140) uniform Frame { CompositeFrame frame; };
layout(binding = 2, std140) uniform Light { SkyLight light; };
layout(binding = 3) uniform sampler2DArray gradientMap;
layout(binding = 4) uniform sampler2DArray momentsMap;
layout(binding = 5) uniform sampler2DArray foamMap;
layout(binding = 6) uniform sampler2D radianceMap;
layout(binding = 7) uniform sampler2D environmentMap;
layout(binding = 8) uniform sampler2D waterPosition;
layout(binding = 9) uniform usampler2D waterBody;
layout(binding = 10) uniform sampler2D waterDepth;
layout(binding = 11) uniform sampler2D hostColor;
layout(binding = 12) uniform sampler2D hostDepth;
layout(binding = 13) uniform writeonly image2D outputImage;
layout(binding = 14) uniform writeonly image2D normalImage;
layout(binding = 15) uniform writeonly image2D slopeVarianceImage;
layout(binding = 16) uniform writeonly image2D mergedDepthImage;
layout(binding = 18) uniform sampler2DArray gainMap;
layout(binding = 21) uniform sampler2D cloudPicture;
layout(binding = 22) uniform sampler2D cloudShadow;
layout(binding = 17) uniform samplerBuffer fresnelTable;

// Largest value written: half floats end at 65504.
const float kLargestRadiance = 60000.0;

// The same number, for the ends of loops and for branches. Lavapipe compiles a shader anew for every dispatch, 10 ms for a
// large one, where they hang on uniforms alone, to write those in; a dispatch has a group at least, which it does not know.
uint notWrittenIn(uint number) { return min(number, number * gl_NumWorkGroups.x); }

// What covers a pixel, and how far it is.
struct Pixel {
  bool water;
  bool host;         // the host's picture shows
  float depth;       // of sea and host merged
  float waterDepth;
};

Pixel readPixel(ivec2 place) {
  Pixel pixel;
  pixel.waterDepth = texelFetch(waterDepth, place, 0).x;
  pixel.water = texelFetch(waterBody, place, 0).x != 0u;
  pixel.host = false;
  pixel.depth = pixel.water ? pixel.waterDepth : frame.rayY.w;
  if (kHasHost) {
    float other = texelFetch(hostDepth, place, 0).x;
    pixel.host = (other - pixel.depth) * frame.nearer > 0.0;
    if (pixel.host) {
      pixel.depth = other;
      pixel.water = false;
    }
  }
  return pixel;
}

// Clip-space w of a depth, its distance along the camera's axis [m].
float axialDistance(float depth) { return frame.ray.w / (depth - frame.rayX.w); }

vec3 pixelRay(ivec2 place) {
  return frame.ray.xyz + float(place.x) * frame.rayX.xyz + float(place.y) * frame.rayY.xyz;
}

#endif
