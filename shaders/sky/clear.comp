#version 460
// Radiance of the clear sky as the eye sees it, relative to the sun's azimuth (it is symmetric about it). Below the horizon,
// where there are rows for it: the light that the air adds on the way to the sea per light that it takes, 1 - transmittance,
// which hardly depends on how far along the way the eye looks.
#extension GL_GOOGLE_include_directive : require
#include "pelagic/shader/types.h"
#include "physics/atmosphere.glsl"
#include "shared/sky_pass.h"
#include "air_lookup.glsl"

const int kSteps = 32;
// Airglow and starlight without a moon, 22 mag/arcsec^2 = 1.7e-4 cd/m^2 of 1.28e5 lx.
const vec3 kNight = vec3(1.3e-9);

layout(local_size_x = kSkyTile, local_size_y = kSkyTile) in;
layout(push_constant) uniform Push { SkyPass pass; };
layout(binding = 0) uniform sampler2D transmittance;
layout(binding = 1, std430) readonly buffer Scattering { vec4 scattering[]; };
layout(binding = 2) writeonly uniform image2D clear;

// Bilinear; half floats would lose the twilight.
vec3 manyTimesScattered(float h, float mu) {
  vec2 place = scatteringPlace(h, mu) * vec2(kScatteringWidth - 1, kScatteringHeight - 1);
  uvec2 low = min(uvec2(place), uvec2(kScatteringWidth - 2, kScatteringHeight - 2));
  vec2 f = place - vec2(low);
  uint i = low.y * kScatteringWidth + low.x;
  return mix(mix(scattering[i].rgb, scattering[i + 1].rgb, f.x),
             mix(scattering[i + kScatteringWidth].rgb, scattering[i + kScatteringWidth + 1].rgb, f.x), f.y);
}

struct Air {
  vec3 light;    // scattered into the path
  vec3 through;  // transmittance of the path
};

Air airAlong(float altitude, float viewMu, float end, float sunMu, float sunView) {
  float rayleigh = rayleighPhase(sunView), mie = miePhase(sunView);
  Air air = Air(vec3(0), vec3(1));
  for (int i = 0; i < kSteps; ++i) {
    float a = float(i) / float(kSteps), b = float(i + 1) / float(kSteps), m = 0.5 * (a + b);
    float t = end * m * m;  // dense near the eye
    float h = clamp(altitudeAlong(altitude, viewMu, t), 0.0, kAirTop);
    float mu = ((kPlanetRadius + altitude) * sunMu + t * sunView) / (kPlanetRadius + h);
    vec3 density = airDensity(h, pass.haze);
    vec3 extinction = airExtinction(density);
    vec3 molecules = kRayleighScattering * density.x, aerosols = mieScattering(density);
    vec3 source = (molecules * rayleigh + aerosols * mie) * sunlightAt(transmittance, h, mu) +
                  (molecules + aerosols) * manyTimesScattered(h, mu);
    vec3 depth = extinction * (end * (b * b - a * a));
    // Exact along the step when the medium is constant in it; 1 - exp(-x) has no digits left where x is small.
    vec3 taken = mix(1.0 - exp(-depth), depth, lessThan(depth, vec3(1e-4)));
    air.light += source * air.through * taken / max(extinction, vec3(1e-12));
    air.through *= 1.0 - taken;
  }
  return air;
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  float azimuth = (float(texel.x) + 0.5) / float(kClearSize);
  azimuth *= kAirPi * azimuth;
  bool below = texel.y < int(pass.airRows);
  float row = below ? -(float(int(pass.airRows) - texel.y) - 0.5) / float(pass.airRows)
                    : (float(texel.y - int(pass.airRows)) + 0.5) / float(kClearSize);
  float elevation = skyElevation(0.5 + 0.5 * row, pass.edge);
  float sunMu = pass.sunDirection.y, sunSide = sqrt(max(0.0, 1.0 - sunMu * sunMu));
  float viewMu = sin(elevation);
  float sunView = viewMu * sunMu + cos(elevation) * sunSide * cos(azimuth);
  // From the water itself the way to it would end at once.
  float altitude = below ? max(pass.altitude, 1.0) : pass.altitude;
  float ground = distanceToGround(altitude, viewMu);
  float end = below && ground >= 0.0 ? ground : distanceToTop(altitude, viewMu);
  Air air = airAlong(altitude, viewMu, end, sunMu, sunView);
  vec3 light = (below ? air.light / max(1.0 - air.through, vec3(1e-7)) : air.light) + kNight * pass.night;
  imageStore(clear, texel, vec4(light * pass.gain, 1));
}
