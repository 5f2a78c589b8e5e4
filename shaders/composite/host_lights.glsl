// The host's lights on the sea. Before it: levelled().
#ifndef PELAGIC_COMPOSITE_HOST_LIGHTS_GLSL
#define PELAGIC_COMPOSITE_HOST_LIGHTS_GLSL
#include "composite/air.glsl"
#include "composite/sea_light.glsl"

// No pipeline that has no lights pays for them.
layout(constant_id = 9) const bool kHostLights = false;

struct HostLit {
  vec3 mirrored;  // radiance that the sea mirrors
  vec3 entering;  // irradiance that enters the water
  vec3 foam;      // irradiance on the foam's relief
};

const HostLit kNoHostLight = HostLit(vec3(0), vec3(0), vec3(0));

// Share of a light that the planet leaves in sight of a point `height` over the still sea: `up` is the sine of its elevation,
// over `distance` [m], and `extent` half of what it takes of elevation. A light before the lowest point of the line to it, which
// water higher than a lamp may look down on, is in sight.
float shareOverHorizon(float up, float distance, float extent, float height) {
  if (distance + frame.planetRadius * up < 0.0) return 1.0;
  float dip = sqrt(2.0 * max(height, 0.0) / frame.planetRadius);
  return clamp(0.5 + 0.5 * (up + dip) / max(extent, 1e-7), 0.0, 1.0);
}

// `place`: from the eye [m], of a point that is `p` away in the plane, of the normal n; `top` is its foam's as for litFoam().
// Loops test at their end: there is one light at least.
HostLit hostLit(SeaPoint sea, vec3 n, vec3 top, vec3 v, vec3 place, vec2 p) {
  Visibility seen = visibility(v, sea.slope, sea.residual);
  HostLit lit = kNoHostLight;
  float height = heightOverSea(place);
  uint i = 0u;
  do {
    vec4 middle = frame.hostLightPlace[i];
    vec3 to = middle.xyz - place;
    float inverse = inversesqrt(max(dot(to, to), max(middle.w * middle.w, 1e-6)));
    // Twilight's gain holds for all light (pelagic/sky.hpp).
    Shining from;
    from.radiance = frame.hostLightRadiance[i].rgb * light.skyIrradiance.w;
    from.l = levelled(to * inverse, p);
    from.radius = middle.w * inverse;
    from.a = levelled(frame.hostLightWidth[i].xyz * inverse, p);
    from.b = levelled(frame.hostLightHeight[i].xyz * inverse, p);
    // Of unit radiance, times the square of the distance, so that it is not too small for a float.
    vec3 panel = panelIrradiance(from.l, from.a, from.b);
    vec3 area = (kPi * middle.w * middle.w) * from.l + panel / (inverse * inverse);
    float shrink = panelShrink(from.l, from.a, from.b, panel);
    from.a *= shrink;
    from.b *= shrink;
    float size = length(area);
    float extent = from.radius + abs(from.a.y) + abs(from.b.y);
    float share = shareOverHorizon(from.l.y, 1.0 / inverse, extent, height);
    from.irradiance = from.radiance * (share * size * inverse * inverse);
    from.l = area / max(size, 1e-9);  // the middle of what is seen of it; none: it shines away
    lit.mirrored += mirroredLight(sea, seen, v, from, true);
    lit.entering += enteringIrradiance(from.irradiance, from.l.y, vec3(0));
    lit.foam += from.irradiance * litFoam(n, top, from.l);
  } while (++i < notWrittenIn(frame.hostLights));
  return lit;
}

#endif
