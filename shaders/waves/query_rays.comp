#version 460
#extension GL_EXT_control_flow_attributes : require
#extension GL_GOOGLE_include_directive : require
// Where rays first meet the surface: followed in steps that no face can overtake, then bisected.
#include "shared/query.h"
#include "pelagic/shader/wave_sampling.h"
#include "waves/query.glsl"

// Height of the ray over the surface at distance t [m].
float gapAt(QueryRay ray, float t) {
  return ray.height + t * ray.direction.y - heightAt(t * ray.direction.xz);
}

void main() {
  const uint item = gl_GlobalInvocationID.x;
  if (item >= push.count) return;
  load(item);
  const QueryRay ray = rays[item];
  const float speed = abs(ray.direction.y) + kSteepestFace * length(ray.direction.xz);
  // Either a step is taken, or the last one is halved: one place that asks for the surface.
  float low = 0;
  float high = 0;
  bool above = true;
  bool met = false;
  bool done = ray.reach < 0;
  uint steps = 0;
  do {
    const float t = met ? 0.5 * (low + high) : high;
    const float gap = gapAt(ray, t);
    above = steps == 0 ? gap >= 0 : above;
    const bool crossed = (gap >= 0) != above;
    const bool halving = met;
    met = met || crossed;
    if (crossed) {
      high = t;
    } else {
      done = done || (!halving && t >= ray.reach);
      low = t;
    }
    if (met) {
      // What 32 bits tell apart: neighbours have nothing between them.
      const float middle = 0.5 * (low + high);
      done = middle <= low || middle >= high || high - low <= 1e-7 * (1 + high);
    } else {
      high = min(t + max(abs(gap) / speed, push.halfCell), ray.reach);
    }
  } while (!done && ++steps < kMostRaySteps);
  storeSurface(item, high * ray.direction.xz, met);
}
