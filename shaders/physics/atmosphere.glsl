// The clear atmosphere: densities, phase functions, rays around the globe and the parametrisations of the sky's maps.
// Compiles as GLSL and as C++. Metres, radians; `mu` is the cosine of a ray's zenith angle, `haze` the
// aerosols' amount, relative to clean air over the sea, and their scale height [m].
#ifndef PELAGIC_PHYSICS_ATMOSPHERE_GLSL
#define PELAGIC_PHYSICS_ATMOSPHERE_GLSL

#include "pelagic/shader/constants.h"

#ifdef __cplusplus
#define PELAGIC_AIR_FORMULA inline
namespace pelagic::shader {
using namespace glm;
inline constexpr float kPlanetRadius = kEarthRadius;  // passes get the sky's own; what runs on the CPU takes it
#else
#define PELAGIC_AIR_FORMULA
layout(constant_id = 1) const float kPlanetRadius = kEarthRadius;  // at sea level [m]
#endif

PELAGIC_SHADER_CONSTANT float kAirPi = 3.14159265f;
PELAGIC_SHADER_CONSTANT float kAirTop = 100000.0f;      // altitude above which there is no air
PELAGIC_SHADER_CONSTANT float kAirAlbedo = 0.06f;       // of the ocean below, diffuse

// Spectra integrated over the CIE colour matching functions into Rec.709, relative to a 5778 K sun. Molecules: scattering
// 1.356e-5 (550 nm/l)^4.08 per metre at sea level. Ozone: 300 Dobson units in a tent 30 km wide around 25 km.
PELAGIC_SHADER_CONSTANT vec3 kRayleighScattering = vec3(7.10e-6f, 1.38e-5f, 3.31e-5f);
PELAGIC_SHADER_CONSTANT float kRayleighHeight = 8000.0f;
PELAGIC_SHADER_CONSTANT vec3 kOzoneAbsorption = vec3(2.58e-6f, 1.71e-6f, 0.0f);
PELAGIC_SHADER_CONSTANT float kOzoneCentre = 25000.0f;
PELAGIC_SHADER_CONSTANT float kOzoneHalfWidth = 15000.0f;
// Clean maritime aerosol (Smirnov et al. 2002) at sea level: with a scale height of 1200 m the optical depth is 0.07 at 550 nm;
// Angstrom exponent 0.4.
PELAGIC_SHADER_CONSTANT vec3 kMieExtinction = vec3(5.50e-5f, 5.86e-5f, 6.38e-5f);
PELAGIC_SHADER_CONSTANT float kMieAlbedo = 0.98f;      // scattering / extinction
PELAGIC_SHADER_CONSTANT float kMieNarrow = 0.9f;       // mean cosines of the two lobes of the phase function
PELAGIC_SHADER_CONSTANT float kMieWide = 0.5f;
PELAGIC_SHADER_CONSTANT float kMieNarrowShare = 0.65f;

// Phase functions [1/sr], mu the cosine of the angle between the directions of travel; both integrate to 1.
PELAGIC_AIR_FORMULA float rayleighPhase(float mu) { return 3.0f / (16.0f * kAirPi) * (1.0f + mu * mu); }

// Henyey & Greenstein (1941), g the mean cosine.
PELAGIC_AIR_FORMULA float henyeyGreenstein(float mu, float g) {
  float d = 1.0f + g * g - 2.0f * g * mu;
  return (1.0f - g * g) / (4.0f * kAirPi * d * sqrt(d));
}

// Sea salt: a narrow aureole over a broad lobe; one lobe of the same mean cosine, 0.76, is too wide for either.
PELAGIC_AIR_FORMULA float miePhase(float mu) {
  return mix(henyeyGreenstein(mu, kMieWide), henyeyGreenstein(mu, kMieNarrow), kMieNarrowShare);
}

// Relative densities at altitude h: molecules, aerosols, ozone.
PELAGIC_AIR_FORMULA vec3 airDensity(float h, vec2 haze) {
  return vec3(exp(-h / kRayleighHeight), haze.x * exp(-h / haze.y),
              max(0.0f, 1.0f - abs(h - kOzoneCentre) / kOzoneHalfWidth));
}

// Extinction [1/m] of the densities d.
PELAGIC_AIR_FORMULA vec3 airExtinction(vec3 d) {
  return kRayleighScattering * d.x + kMieExtinction * d.y + kOzoneAbsorption * d.z;
}
PELAGIC_AIR_FORMULA vec3 mieScattering(vec3 d) { return kMieExtinction * (kMieAlbedo * d.y); }

// Altitude after the distance t along a ray from altitude h: r^2 - R^2 is summed without the cancelling R^2.
PELAGIC_AIR_FORMULA float altitudeAlong(float h, float mu, float t) {
  float q = h * (2.0f * kPlanetRadius + h) + t * (2.0f * (kPlanetRadius + h) * mu + t);
  return q / (sqrt(kPlanetRadius * kPlanetRadius + q) + kPlanetRadius);
}

// Distance from altitude h inside the air to its top.
PELAGIC_AIR_FORMULA float distanceToTop(float h, float mu) {
  float b = (kPlanetRadius + h) * mu;
  float c = (kAirTop - h) * (2.0f * kPlanetRadius + kAirTop + h);
  float root = sqrt(b * b + c);
  return b > 0.0f ? c / (root + b) : root - b;
}

// Distance to the globe's near surface, negative when the ray misses it.
PELAGIC_AIR_FORMULA float distanceToGround(float h, float mu) {
  float b = (kPlanetRadius + h) * mu;
  float c = h * (2.0f * kPlanetRadius + h);
  float discriminant = b * b - c;
  if (mu >= 0.0f || discriminant < 0.0f) return -1.0f;
  return c / (sqrt(discriminant) - b);
}

// Cosine of the zenith angle of the globe's edge seen from altitude h.
PELAGIC_AIR_FORMULA float horizonCosine(float h) {
  return -sqrt(h * (2.0f * kPlanetRadius + h)) / (kPlanetRadius + h);
}

// Optical depth from altitude h to the top of the air by the midpoint rule. Samples crowd as t = t0 + x|x| around the
// ray's lowest point t0, where the density peaks.
PELAGIC_AIR_FORMULA vec3 airOpticalDepth(float h, float mu, vec2 haze, int steps) {
  float end = distanceToTop(h, mu);
  float lowest = clamp(-(kPlanetRadius + h) * mu, 0.0f, end);
  float from = -sqrt(lowest);
  float step = (sqrt(end - lowest) - from) / float(steps);
  vec3 depth = vec3(0.0f);
  for (int i = 0; i < steps; ++i) {
    float x = from + (float(i) + 0.5f) * step;
    vec3 density = airDensity(max(0.0f, altitudeAlong(h, mu, lowest + x * abs(x))), haze);
    depth += airExtinction(density) * (2.0f * abs(x) * step);
  }
  return depth;
}

// Share of the sun's disc above a straight edge, `elevation` of its centre above the edge.
PELAGIC_AIR_FORMULA float sunDiscShare(float elevation) {
  float x = clamp(elevation / kSunAngularRadius, -1.0f, 1.0f);
  if (x == -1.0f) return 0.0f;  // asin() of a device may leave a little
  return 0.5f + (x * sqrt(1.0f - x * x) + asin(x)) / kAirPi;
}

// Share of the disc that an observer at altitude h sees above the globe's edge.
PELAGIC_AIR_FORMULA float sunVisibility(float h, float mu) {
  float edge = horizonCosine(h);
  return sunDiscShare((mu - edge) / sqrt(1.0f - edge * edge));
}

// Transmittance map (Bruneton & Neyret 2008): x how far the top is between its nearest and its farthest, y distance to
// the horizon. In 0 ... 1; rays below the horizon are held at it.
PELAGIC_AIR_FORMULA vec2 transmittancePlace(float h, float mu) {
  float edge = sqrt(h * (2.0f * kPlanetRadius + h));
  float edgeOfTop = sqrt(kAirTop * (2.0f * kPlanetRadius + kAirTop));
  float nearest = kAirTop - h;
  float farthest = edge + edgeOfTop;
  float d = distanceToTop(h, max(mu, horizonCosine(h)));
  return vec2(clamp((d - nearest) / (farthest - nearest), 0.0f, 1.0f), edge / edgeOfTop);
}
// Its inverse: altitude and mu.
PELAGIC_AIR_FORMULA vec2 transmittanceRay(vec2 place) {
  float edgeOfTop = sqrt(kAirTop * (2.0f * kPlanetRadius + kAirTop));
  float edge = place.y * edgeOfTop;
  float h = min(edge * edge / (sqrt(kPlanetRadius * kPlanetRadius + edge * edge) + kPlanetRadius), kAirTop);
  float nearest = kAirTop - h;
  float d = nearest + place.x * (edge + edgeOfTop - nearest);
  float mu = d > 0.0f ? (edgeOfTop * edgeOfTop - edge * edge - d * d) / (2.0f * (kPlanetRadius + h) * d) : 1.0f;
  return vec2(h, clamp(mu, horizonCosine(h), 1.0f));
}

// Multiple-scattering map: x over the sun's mu from 20 degrees below the horizon to the zenith, dense at the horizon;
// y over altitude, dense at the sea. In 0 ... 1.
PELAGIC_SHADER_CONSTANT float kScatteringLowest = -0.585f;  // signed square root of the lowest mu, sin(-20 degrees)
PELAGIC_AIR_FORMULA vec2 scatteringPlace(float h, float mu) {
  float s = (mu < 0.0f ? -1.0f : 1.0f) * sqrt(abs(mu));
  return vec2(clamp((s - kScatteringLowest) / (1.0f - kScatteringLowest), 0.0f, 1.0f),
              sqrt(clamp(h / kAirTop, 0.0f, 1.0f)));
}
PELAGIC_AIR_FORMULA vec2 scatteringPoint(vec2 place) {
  float s = mix(kScatteringLowest, 1.0f, place.x);
  return vec2(kAirTop * place.y * place.y, s * abs(s));
}

// Elevation of the edge of a globe of the given radius seen from altitude h [rad], <= 0.
PELAGIC_AIR_FORMULA float horizonElevation(float h, float radius) {
  return -atan(sqrt(h * (2.0f * radius + h)) / radius);
}

// Rows of the sky maps: elevation -> v and back, v = 0.5 at the eye's horizon `edge`, denser there.
PELAGIC_AIR_FORMULA float skyRow(float elevation, float edge) {
  float from = elevation - edge;
  float s = sqrt(abs(from) / (0.5f * kAirPi + (from < 0.0f ? edge : -edge)));
  return 0.5f + 0.5f * (from < 0.0f ? -s : s);
}
PELAGIC_AIR_FORMULA float skyElevation(float row, float edge) {
  float s = 2.0f * row - 1.0f;
  return edge + (0.5f * kAirPi + (s < 0.0f ? edge : -edge)) * s * abs(s);
}
// Texture coordinates of a direction in the radiance map of sea level.
PELAGIC_AIR_FORMULA vec2 skyUv(vec3 direction) {
  float u = atan(direction.z, direction.x) / (2.0f * kAirPi);
  return vec2(u < 0.0f ? u + 1.0f : u, skyRow(asin(clamp(direction.y, -1.0f, 1.0f)), 0.0f));
}

// CIE standard overcast sky (Moon & Spencer 1942), relative to the zenith.
PELAGIC_AIR_FORMULA float cieOvercast(float sinElevation) { return (1.0f + 2.0f * sinElevation) / 3.0f; }

#ifdef __cplusplus
}  // namespace pelagic::shader
#endif
#undef PELAGIC_AIR_FORMULA
#endif
