// Rectangles that shine evenly from one side, by Lambert's law: what a point receives of one, and the slopes that mirror it.
// From the point, in units of its distance r from the middle: l is the unit vector to the middle, a and b are the half-axes
// over r. The side that shines is the one that cross(a, b) leaves.
#ifndef PELAGIC_PHYSICS_PANEL_GLSL
#define PELAGIC_PHYSICS_PANEL_GLSL
#include "physics/formula.h"

PELAGIC_PHYSICS_BEGIN

// Of an edge from p along e to p + e: the angle it subtends over |p x e|.
PELAGIC_FORMULA float panelEdge(vec3 p, vec3 e) {
  float s = max(length(cross(p, e)), 1e-9f);
  return atan(s, dot(p, p + e)) / s;
}

// Integral of the direction over the solid angle: times the radiance, it is the irradiance on a plane that faces it, which it
// points to. Near, Lambert's formula for polygons, half the sum of the edges' angles times the normals of their planes, with the
// parts taken out that cancel in it; of small rectangles those left do so too, and the series to the second order of the half-axes
// is better. Errors below 2e-3, in the mean a tenth of it, where none of the half-axes is 1000 times the other.
PELAGIC_FORMULA vec3 panelIrradiance(vec3 l, vec3 a, vec3 b) {
  vec3 n = cross(a, b);
  float facing = -dot(n, l);
  if (facing <= 0.0f) return vec3(0.0f);
  if (max(dot(a, a), dot(b, b)) < 0.01f) {
    float la = dot(l, a), lb = dot(l, b);
    float along = 1.0f - 0.66666667f * (dot(a, a) + dot(b, b)) + 4.0f * (la * la + lb * lb);
    return 4.0f * facing * (along * l - 1.33333333f * (la * a + lb * b));
  }
  float w1 = panelEdge(l + a + b, -2.0f * a), w2 = panelEdge(l - a + b, -2.0f * b);
  float w3 = panelEdge(l - a - b, 2.0f * a), w4 = panelEdge(l + a - b, 2.0f * b);
  return cross(l, (w1 - w3) * a + (w2 - w4) * b) - (w1 + w2 + w3 + w4) * n;
}

// Factor on a and b, so that a small rectangle of them takes as much of the sky as this large one does.
PELAGIC_FORMULA float panelShrink(vec3 l, vec3 a, vec3 b, vec3 irradiance) {
  float small = -4.0f * dot(cross(a, b), l);
  return small > 0.0f ? sqrt(length(irradiance) / small) : 1.0f;
}

// How the slope of the facet that mirrors l to v changes as l moves by d: less (d + s d.y).xz / (v.y + l.y) of what is across l.
PELAGIC_FORMULA vec2 mirrorSlopeChange(vec2 slope, vec3 v, vec3 l, vec3 d) {
  vec3 across = d - dot(d, l) * l;
  return -(vec2(across.x, across.z) + slope * across.y) / max(v.y + l.y, 1e-5f);
}

// Covariance that the rectangle adds to the slopes that mirror it, from the changes by its half-axes: evenly spread, each has a
// third of its square.
PELAGIC_FORMULA vec3 panelCovariance(vec2 u, vec2 w) {
  return vec3(u.x * u.x + w.x * w.x, u.y * u.y + w.y * w.y, u.x * u.y + w.x * w.y) / 3.0f;
}

PELAGIC_PHYSICS_END
#endif
