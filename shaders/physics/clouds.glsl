// A layer of clouds between two altitudes: where rays cross it, how dense it is and how it scatters light.
// Compiles as GLSL and, through GLM, as C++. Metres, `mu` the cosine of a ray's zenith angle.
#ifndef PELAGIC_PHYSICS_CLOUDS_GLSL
#define PELAGIC_PHYSICS_CLOUDS_GLSL
#include "physics/atmosphere.glsl"
#include "physics/air_path.glsl"
#include "physics/cloud_weather.glsl"
#include "physics/formula.h"

PELAGIC_PHYSICS_BEGIN

#ifdef __cplusplus
using namespace pelagic::shader;  // NOLINT: the atmosphere's names
#endif

// Extinction where a cloud is dense [1/m]: cumulus of 100 drops of 8 um per cubic centimetre, 0.04.
PELAGIC_FORMULA_CONSTANT float kCloudExtinction = 0.04f;
// Share of it that dims the sea's sun: of the light that drops scatter, mean cosine g = 0.85, the forward peak g^2 goes on as if
// it had not been scattered (Joseph, Wiscombe & Weinman 1976); a sea of 3 m/s spreads the sun's image by 15 degrees itself.
PELAGIC_FORMULA_CONSTANT float kCloudDimming = 1.0f - 0.85f * 0.85f;

// Distance from the altitude h to the sphere of the altitude `shell` along a ray that climbs through it or starts inside
// it; without cancellation.
PELAGIC_FORMULA float distanceUpTo(float h, float shell, float mu) {
  float b = (kPlanetRadius + h) * mu;
  float c = (shell - h) * (2.0f * kPlanetRadius + shell + h);
  float root = sqrt(max(b * b + c, 0.0f));
  return b > 0.0f ? c / (root + b) : root - b;
}

// Distance from h down to the sphere of the altitude `shell` < h, negative when the ray misses it.
PELAGIC_FORMULA float distanceDownTo(float h, float shell, float mu) {
  float b = (kPlanetRadius + h) * mu;
  float c = (h - shell) * (2.0f * kPlanetRadius + shell + h);
  float discriminant = b * b - c;
  if (mu >= 0.0f || discriminant < 0.0f) return -1.0f;
  return c / (sqrt(discriminant) - b);
}

// Where a ray from the altitude h enters the layer and where it leaves it, first time through; equal where it misses it or
// meets the sea before.
PELAGIC_FORMULA vec2 cloudSpan(float h, float mu, float base, float top) {
  vec2 span = vec2(0.0f);
  if (h < base) {
    if (distanceDownTo(max(h, 0.0f), 0.0f, mu) < 0.0f) span = vec2(distanceUpTo(h, base, mu), distanceUpTo(h, top, mu));
  } else {
    float entry = h > top ? distanceDownTo(h, top, mu) : 0.0f;
    float down = distanceDownTo(h, base, mu);
    if (entry >= 0.0f) span = vec2(entry, down >= 0.0f ? down : distanceUpTo(h, top, mu));
  }
  span.y = min(span.y, span.x + kCloudLongest * (top - base));
  return span;
}

// The field where bubbles, of which `hole` 0 ... 1 tells how far the nearest is, tear the clouds' edges.
PELAGIC_FORMULA_CONSTANT float kMeanHole = 0.524f;   // of random points in cubic cells, 1.1 % apart in its three sizes
PELAGIC_FORMULA_CONSTANT float kLeastHole = 0.1f;    // of which hardly one is less
PELAGIC_FORMULA float tornField(float field, float hole) { return field - 1.1f * (hole - 0.45f); }

// Share of the densest cloud's extinction from the volume's field, whose 0 is the cloud's edge.
PELAGIC_FORMULA float cloudDensity(float field) { return clamp(2.0f * field, 0.0f, 1.0f); }

// Its mean on a way along which the field runs evenly from a to b. Samples alone would show where they lie: as slices of the
// clouds' edges, which are thinner than a step.
PELAGIC_FORMULA float cloudDensityBetween(float a, float b) {
  // The integral of cloudDensity from 0.
  float low = cloudDensity(a), high = cloudDensity(b);
  float upTo = 0.25f * high * high + max(b - 0.5f, 0.0f), from = 0.25f * low * low + max(a - 0.5f, 0.0f);
  return abs(b - a) > 1e-3f ? (upTo - from) / (b - a) : 0.5f * (low + high);
}

// Share of diffuse light that comes down through the cloud above a place that the sun's light, at an elevation of the sine
// `sunY`, reaches with the transmittance q^4: two streams through drops that absorb nothing, 1/(1 + 3/4 (1 - g) tau) with g = 0.85
// and tau the vertical optical depth (Bohren 1987). The sun's way is followed for 6 thicknesses of the layer: of a lower sun's,
// along the layer, a sixth is taken for the depth above.
PELAGIC_FORMULA float cloudDiffuse(float q, float sunY) {
  return 1.0f / (1.0f - 0.45f * log(max(q, 1e-7f)) * max(sunY, 1.0f / 6.0f));
}

// Light toward the eye per irradiance of a sun whose light comes with the transmittance q^4 [1/sr], mu the cosine of the angle
// between the directions of travel, sunY the sine of its elevation. Drops scatter forward (mean cosine 0.85); what is scattered
// again is taken as the same light spread wider and taken less (Wrenninge et al. 2013), each order 3/4 of the one before, down to
// an even rest. Through a layer would come cloudDiffuse() of the sun's light, E sin(h) T / pi; clouds that are not layers lose
// over half of it by their sides. It is no more than the even rest at the top.
PELAGIC_FORMULA_CONSTANT float kCloudLayered = 0.45f;
PELAGIC_FORMULA float cloudScattering(float mu, float q, float sunY) {
  float q2 = q * q;
  float once = 0.8f * henyeyGreenstein(mu, 0.85f) + 0.2f * henyeyGreenstein(mu, -0.2f);
  float twice = 0.8f * henyeyGreenstein(mu, 0.5f) + 0.2f * henyeyGreenstein(mu, -0.1f);
  float rest = max(1.7f * sqrt(q), kCloudLayered * min(4.0f * max(sunY, 0.0f), 1.7f) * cloudDiffuse(q, sunY));
  return once * q2 * q2 + 0.75f * twice * q2 + (0.56f * q + rest) / (4.0f * kAirPi);
}

PELAGIC_PHYSICS_END
#endif
