#version 460
// Exposure from the picture: its mean luminance, of logarithms, becomes middle grey. One work-group looks at 64 x 64 pixels
// spread over the picture, so that its cost does not depend on the size.
#extension GL_GOOGLE_include_directive : require
#include "physics/tone.glsl"

const uint kThreads = 256u, kSide = 64u;
layout(local_size_x = kThreads) in;
layout(binding = 0) uniform sampler2D inputImage;
layout(binding = 1, std430) writeonly buffer Gain { float gain; };
layout(push_constant) uniform Push {
  float compensation;  // [EV]
};

shared float partial[kThreads];

void main() {
  uint self = gl_LocalInvocationIndex;
  ivec2 size = textureSize(inputImage, 0);
  float sum = 0.0;
  for (uint i = self; i < kSide * kSide; i += kThreads) {
    vec2 place = (vec2(i % kSide, i / kSide) + 0.5) / float(kSide) * vec2(size);
    sum += meteredStops(texelFetch(inputImage, min(ivec2(place), size - 1), 0).rgb);
  }
  partial[self] = sum;
  for (uint half_ = kThreads / 2u; half_ > 0u; half_ /= 2u) {
    barrier();
    if (self < half_) partial[self] += partial[self + half_];
  }
  if (self == 0u) gain = exp2(clamp(meteredExposure(partial[0] / float(kSide * kSide)) + compensation, -32.0, 32.0));
}
