// The ocean BRDF of Ross, Dion & Potvin (2005) and Bruneton et al. (2010), for Gaussian slopes about any mean.
//
// Slopes are those of the elevation over the horizontal plane, s = (dy/dx, dy/dz); a facet's normal is (-s.x, 1, -s.y)
// over its length. The papers tilt a frame so that the mean slope is 0. Here the frame stays level, the slopes have the
// mean m and covariance C, and a direction v sees the signed area X(s) = v.y - (v.x s.x + v.z s.y) of a facet over a unit
// of the plane. X is Gaussian with the mean mu = v.y - vh.m and the variance tau^2 = vh' C vh, so that the area seen is
// E[max(X,0)] = mu Phi(mu/tau) + tau phi(mu/tau) = mu (1 + Lambda(a)), a = mu/(sqrt(2) tau): the papers' cos(theta) (1 +
// Lambda) when m = 0, and defined for faces turned away (mu <= 0) as well.
#ifndef PELAGIC_PHYSICS_OCEAN_BRDF_GLSL
#define PELAGIC_PHYSICS_OCEAN_BRDF_GLSL
#include "physics/formula.h"

PELAGIC_PHYSICS_BEGIN

// A symmetric 2 x 2 matrix is a vec3: xx, zz, xz.

PELAGIC_FORMULA vec2 covarianceTimes(vec3 c, vec2 a) { return vec2(c.x * a.x + c.z * a.y, c.z * a.x + c.y * a.y); }

// a' C a
PELAGIC_FORMULA float covarianceAlong(vec3 c, vec2 a) {
  return c.x * a.x * a.x + c.y * a.y * a.y + 2.0f * c.z * a.x * a.y;
}

PELAGIC_FORMULA float covarianceDeterminant(vec3 c) { return max(c.x * c.y - c.z * c.z, 1e-16f); }

// Covariance with the variances `along` and `across` the unit vector d.
PELAGIC_FORMULA vec3 covarianceOf(float along, float across, vec2 d) {
  return vec3(along * d.x * d.x + across * d.y * d.y, along * d.y * d.y + across * d.x * d.x,
              (along - across) * d.x * d.y);
}

// Gaussian density of a slope that lies `s` from the mean [1].
PELAGIC_FORMULA float slopeDensity(vec2 s, vec3 c) {
  float determinant = covarianceDeterminant(c);
  float q = (c.y * s.x * s.x - 2.0f * c.z * s.x * s.y + c.x * s.y * s.y) / determinant;
  return exp(-0.5f * q) / (6.28318531f * sqrt(determinant));
}

// Upper tail of the normal distribution times e^(z^2/2), z >= 0: Abramowitz & Stegun 7.1.26, |error| of the tail
// <= 7.5e-8 .. 1.5e-7.
PELAGIC_FORMULA float scaledTail(float z) {
  float t = 1.0f / (1.0f + 0.3275911f * 0.70710678f * z);
  return 0.5f * t *
         (0.254829592f + t * (-0.284496736f + t * (1.421413741f + t * (-1.453152027f + t * 1.061405429f))));
}

// Which facets are seen. Smith's law hides one facet as well as another; on a sea, whose waves carry ever smaller ones, a
// facet is in sight when all the longer waves it sits on face the viewer as well. From the long waves to the short X is a
// random walk that starts at mu and ends where it turns away, so that by the principle of reflection a facet of X is seen in
// proportion to max(X,0) (1 - exp(-2 (X + b tau)(mu + b tau)/tau^2)): Smith's law has b = infinity, a continuous walk 0. A
// walk of n steps has b = 0.58/sqrt(n) (Broadie, Glasserman & Kou 1997). 0.2 is what surfaces traced by rays show whose
// shortest waves are 1/30 as long as the longest.
PELAGIC_FORMULA_CONSTANT float kSightMargin = 0.2f;

// What is in sight of x = X/tau: its density is x (phi(x - z) - phi(x + y)) with y = z + 2b, what Smith's law sees less its
// image; z = mu/tau >= 0.
struct Sight {
  float area;      // integral of the density [1]
  float mean;      // of x
  float variance;  // of x, 0.4 ... 1
};

// `density`, `fraction`: phi(z) and Phi(z).
PELAGIC_FORMULA Sight sightOf(float z, float density, float fraction) {
  float y = min(z + 2.0f * kSightMargin, 12.0f);
  float imageDensity = 0.39894228f * exp(-0.5f * y * y);
  float tail = 2.50662827f * imageDensity * scaledTail(y);
  // Of the image: area, and first and second moments of x about z.
  float area = imageDensity - y * tail;
  float first = (y * y + 1.0f) * tail - y * imageDensity;
  float second = (y * y + 2.0f) * imageDensity - (y * y + 3.0f) * y * tail - z * (2.0f * first - z * area);
  first -= z * area;
  Sight r;
  r.area = z * fraction + density - area;
  float from = (fraction - first) / r.area;
  r.mean = z + from;
  r.variance = 1.0f + (density + area - second) / r.area - from * from;
  return r;
}

// What a direction sees of the slopes.
struct Visibility {
  float mean;        // mu: area of the mean facet seen, per unit of the plane [1]; negative: turned away
  float deviation;   // tau [1]
  float area;        // E[max(X,0)] [1]; of the papers, whom tests compare with
  float fraction;    // Phi(mu/tau): share of the facets that face the direction [1]
  float density;     // phi(mu/tau) [1]
  float inSight;     // area of what longer waves do not hide either [1]; of a mean facet turned away that of one edge on
};

// A mean facet turned away is seen as one edge on.
PELAGIC_FORMULA Sight sightOfFacet(Visibility r) {
  return r.mean > 0.0f ? sightOf(r.mean / r.deviation, r.density, r.fraction) : sightOf(0.0f, 0.39894228f, 0.5f);
}

PELAGIC_FORMULA Visibility visibility(vec3 v, vec2 mean, vec3 c) {
  Visibility r;
  vec2 h = vec2(v.x, v.z);
  r.mean = v.y - dot(h, mean);
  r.deviation = sqrt(max(covarianceAlong(c, h), 1e-10f));
  float z = r.mean / r.deviation;
  float a = min(abs(z), 12.0f);
  float gauss = exp(-0.5f * a * a);
  float tail = gauss * scaledTail(a);
  r.density = 0.39894228f * gauss;
  r.fraction = z >= 0.0f ? 1.0f - tail : tail;
  // Turned far away both terms cancel; the asymptote of the Gaussian's second integral does not.
  r.area = z < -3.0f ? r.deviation * r.density / (a * a + 3.0f) : r.mean * r.fraction + r.deviation * r.density;
  r.inSight = r.deviation * sightOfFacet(r).area;
  return r;
}

// Lambda of Smith's shadowing for the light, (e^(-a^2) - a sqrt(pi) erfc a) / (2 a sqrt(pi)): the sunlit side of a mean
// facet turned toward the light. The papers' law, as a reference: sunReflection() has the walk's.
PELAGIC_FORMULA float smithLambda(Visibility r) { return max(r.area / r.mean - 1.0f, 0.0f); }

// Share in sight of the facets of X = `facing` that face the direction.
PELAGIC_FORMULA float shareInSight(Visibility r, float facing) {
  float z = max(r.mean / r.deviation, 0.0f);
  float x = max(facing / r.deviation, 0.0f);
  return 1.0f - exp(-2.0f * min((x + kSightMargin) * (z + kSightMargin), 40.0f));
}

// Mean and covariance of the slopes seen.
struct SeenSlopes {
  vec2 shift;  // of the mean, from that of all slopes
  vec3 covariance;
};

// Where X of the facets seen is `facing` deviations over max(mu,0) in the mean and has `variance` tau^2: X alone is not
// Gaussian then; the slopes follow it by s - m = -C vh (X - mu)/tau^2.
PELAGIC_FORMULA SeenSlopes seenSlopes(Visibility r, vec3 v, vec3 c, float facing, float variance) {
  vec2 g = covarianceTimes(c, vec2(v.x, v.z)) / r.deviation;
  SeenSlopes s;
  s.shift = g * (min(r.mean / r.deviation, 0.0f) - facing);
  s.covariance = c + (variance - 1.0f) * vec3(g.x * g.x, g.y * g.y, g.x * g.y);
  return s;
}

// The slope m of waves on a facet that the direction v sees with the area `mu` > 0, moved to where such waves are in sight;
// c: their covariance. A surface drawn coarser than it is shaded hides what its own facets hide, but none of the finer
// waves': v is to see them as if it did.
PELAGIC_FORMULA vec2 facingSlope(vec2 m, vec3 v, float mu, vec3 c) {
  vec2 h = vec2(v.x, v.z);
  vec2 g = covarianceTimes(c, h);
  float tau2 = dot(g, h);
  if (tau2 < 1e-8f) return m;
  float tau = sqrt(tau2);
  float z = mu / tau;
  float density = 0.39894228f * exp(-0.5f * z * z);
  Sight sight = sightOf(z, density, 1.0f - 2.50662827f * density * scaledTail(z));
  float x = v.y - dot(h, m);
  float facing = tau * sight.mean + sqrt(sight.variance) * (x - mu);
  return m - (facing - x) / tau2 * g;
}

// Slope of the facet that mirrors l to v.
PELAGIC_FORMULA vec2 mirrorSlope(vec3 v, vec3 l) {
  float y = max(v.y + l.y, 1e-5f);
  return vec2(-(v.x + l.x), -(v.z + l.z)) / y;
}

// The direction r in which the facet of the slope s mirrors v, by its stereographic place r.xz / (1 + r.y):
// r = 2 q m / M - v with m = (-s.x, 1, -s.y), q = m.v and M = m.m, so that place and derivatives are ratios of polynomials.
struct Mirrored {
  vec2 place;
  vec2 alongX;  // derivative of the place by s.x
  vec2 alongZ;  // by s.y
};

PELAGIC_FORMULA Mirrored mirroredBy(vec2 s, vec3 v) {
  vec2 h = vec2(v.x, v.z);
  float q = v.y - dot(h, s);
  float m = 1.0f + dot(s, s);
  float b = max(2.0f * q + m * (1.0f - v.y), 0.05f * m);  // m (1 + r.y); 0 straight down
  vec2 halfSlope = s * (1.0f - v.y) - h;                   // half the derivative of b by s
  Mirrored r;
  r.place = (-2.0f * q * s - m * h) / b;
  r.alongX = (s * v.x - h * s.x - vec2(q, 0) - r.place * halfSlope.x) * (2.0f / b);
  r.alongZ = (s * v.z - h * s.y - vec2(0, q) - r.place * halfSlope.y) * (2.0f / b);
  return r;
}

// Share of the sky in what facets mirror whose slopes have the mean `slope` and the covariance c; `all`: covariance of the
// whole sea's slopes, and w its reflectance seen from the horizon (without gains). A facet mirrors the height
// r.y = 2 v.m/(m.m) - v.y, m = (-s.x, 1, -s.y). Waves hide a low ray from it as they hide the sun: all below a height that is
// about 0.5 deviations of the sea's slopes along the view, times its sine, in the mean, with as large a deviation. Both
// spreads together are taken as normal, and that as a logistic curve. A hidden ray meets another wave, the more obliquely the
// higher it goes; grazing views send it up, steep ones down. Both constants of that, and the power of the reflectance, are
// fitted to traced rays (unit sea_albedo_test has the whole).
PELAGIC_FORMULA_CONSTANT float kHidingHeight = 0.48f;
PELAGIC_FORMULA float shareOfSky(vec2 slope, vec3 c, vec3 v, vec4 all) {
  vec2 h = vec2(v.x, v.z);
  float m = 1.0f + dot(slope, slope) + c.x + c.y;
  float height = 2.0f * (v.y - dot(h, slope)) / m - v.y;
  float hiding = kHidingHeight * kHidingHeight * covarianceAlong(vec3(all.x, all.y, all.z), h);
  float variance = 4.0f * covarianceAlong(c, h) / (m * m) + hiding;
  float over = (height - sqrt(hiding)) * inversesqrt(max(variance, 1e-8f));
  float seen = 1.0f / (1.0f + exp(-1.702f * clamp(over, -20.0f, 20.0f)));
  float again = pow(all.w, 0.3f + 1.15f * sqrt(max(v.y, 0.0f)));
  return mix(again, 1.0f, seen);
}

// Covariance that a disc light of angular radius `radius` [rad] adds to the slopes that mirror it: r^2/16 in the plane of
// incidence, r^2/(16 cos^2) across, carried from the half vector h (cos: of v to h) to slopes.
PELAGIC_FORMULA vec3 discCovariance(vec2 slope, vec3 l, float cosIncidence, float radius) {
  float y2 = 1.0f / (1.0f + dot(slope, slope));  // h.y^2
  float k = radius * radius / (16.0f * max(cosIncidence * cosIncidence, 1e-4f) * y2);
  vec2 w = vec2(l.x, l.z) + slope * l.y;
  return k * vec3(1.0f + slope.x * slope.x - w.x * w.x, 1.0f + slope.y * slope.y - w.y * w.y,
                  slope.x * slope.y - w.x * w.y);
}

// Radiance mirrored from a light of unit irradiance (on a plane facing it), without Fresnel's factor [1/sr]: the papers'
// I_sun / (L_sun Omega_sun F), p(s_h) / (4 h.y^4) over the area seen, but of facets in sight of both the viewer and the
// light, whose X is the same for both. `c` includes discCovariance().
PELAGIC_FORMULA float sunReflection(Visibility seen, Visibility lit, vec3 v, vec2 slope, vec2 mean, vec3 c) {
  // No facet of the sea is as steep as 2, 8 deviations at 20 m/s (Cox & Munk 1954); light and viewer both at the horizon ask
  // for steeper ones beside the light, where the Gaussian that stands for its disc has tails.
  if (lit.mean <= 1e-6f || dot(slope, slope) > 4.0f) return 0.0f;
  float inverseY2 = 1.0f + dot(slope, slope);
  float facing = v.y - (v.x * slope.x + v.z * slope.y);
  float seenShare = shareInSight(seen, facing) / seen.inSight;
  float litShare = shareInSight(lit, facing) * lit.mean / lit.inSight;
  return 0.25f * slopeDensity(slope - mean, c) * inverseY2 * inverseY2 * seenShare * litShare;
}

// Of a disc's covariance in slopes: how far its edge is from its centre along `away`, times the length of that.
PELAGIC_FORMULA float discReach(vec3 disc, vec2 away) { return 2.0f * sqrt(max(covarianceAlong(disc, away), 0.0f)); }

// The most that a light may mirror, as sunReflection(): as if all of it stood where its edge comes nearest to the mean slope,
// `reach` from its centre's slope as discReach() has it. The Gaussian that stands for a light has tails, which grazing views
// of large ones would see as light.
PELAGIC_FORMULA float reflectionBound(Visibility seen, Visibility lit, vec3 v, vec2 slope, vec2 mean, vec3 c, float reach) {
  vec2 away = slope - mean;
  float nearer = max(1.0f - reach / max(dot(away, away), 1e-12f), 0.0f);
  return sunReflection(seen, lit, v, mean + nearer * away, mean, c);
}

PELAGIC_PHYSICS_END
#endif
