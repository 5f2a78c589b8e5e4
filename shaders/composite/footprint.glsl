// How much of a cascade a pixel can resolve.
#ifndef PELAGIC_COMPOSITE_FOOTPRINT_GLSL
#define PELAGIC_COMPOSITE_FOOTPRINT_GLSL

// A cascade holds no wave longer than 1/16 of its patch (pelagic::waveLayout), so that a footprint of that length [m]
// leaves nothing of it but its variance.
const float kLongestWave = 1.0 / 16.0;

// Cascades, counted from the longest, of which something is left at the footprint.
uint cascadesToSample(float footprint) {
  uint count = 0u;
  for (uint c = 0u; c < frame.waves.cascades; ++c) {
    if (footprint < frame.waves.placement[c].w * kLongestWave) count = c + 1u;
  }
  return count;
}

#endif
