#version 460
// HDR to 8 bits: white balance, exposure, film curve, sRGB, dither.
#extension GL_GOOGLE_include_directive : require
#include "physics/tone.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D inputImage;
layout(binding = 1) uniform writeonly image2D outputImage;
layout(binding = 2, std430) readonly buffer Gain { float gain; };  // 2^EV

layout(push_constant) uniform Push { mat3x4 whiteBalance; };  // rows

// Interleaved gradient noise (Jimenez 2014): 0 ... 1, evenly spread over every 3 x 3 pixels, the same in each frame.
float ditherNoise(uvec2 place) {
  return fract(52.9829189 * fract(dot(vec2(place), vec2(0.06711056, 0.00583715))));
}

void main() {
  ivec2 place = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = textureSize(inputImage, 0);
  if (place.x >= size.x || place.y >= size.y) return;
  vec3 exposed = clamp(texelFetch(inputImage, place, 0).rgb * gain, vec3(0), vec3(1e6));
  vec3 radiance = max(vec4(exposed, 0) * whiteBalance, vec3(0));
  vec3 encoded = encodeSrgb(filmCurve(radiance));
  // Storing rounds to the nearest step: half a step either way keeps the mean.
  float dither = (ditherNoise(uvec2(place) & 1023u) - 0.5) / 255.0;
  imageStore(outputImage, place, vec4(encoded + dither, 1));
}
