// Lookups into the maps of the air. Include after atmosphere.glsl and sky_pass.h.

vec3 sunlightAt(sampler2D transmittance, float h, float mu) {
  const vec2 size = vec2(kTransmittanceWidth, kTransmittanceHeight);
  vec2 place = transmittancePlace(h, mu);
  return textureLod(transmittance, (place * (size - 1) + 0.5) / size, 0).rgb * sunVisibility(h, mu);
}
