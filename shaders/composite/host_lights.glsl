// The host's lights on the sea. Before it: levelled().
#ifndef PELAGIC_COMPOSITE_HOST_LIGHTS_GLSL
#define PELAGIC_COMPOSITE_HOST_LIGHTS_GLSL
#include "composite/sea_light.glsl"

// No pipeline that has no lights pays for them.
layout(constant_id = 9) const bool kHostLights = false;

struct HostLit {
  vec3 mirrored;  // radiance that the sea mirrors
  vec3 entering;  // irradiance that enters the water
  vec3 foam;      // irradiance on the sea's mean slope
};

const HostLit kNoHostLight = HostLit(vec3(0), vec3(0), vec3(0));

// `place`: from the eye [m], of a point that is `p` away in the plane. Loops test at their end: there is one light at least.
HostLit hostLit(SeaPoint sea, vec3 v, vec3 place, vec2 p) {
  Visibility seen = visibility(v, sea.slope, sea.residual);
  HostLit lit = kNoHostLight;
  uint i = 0u;
  do {
    vec4 ball = frame.hostLightPlace[i];
    vec3 to = ball.xyz - place;
    float inverse = inversesqrt(max(dot(to, to), ball.w * ball.w));
    vec3 l = levelled(to * inverse, p);
    // Twilight's gain holds for all light (pelagic/sky.hpp).
    vec3 intensity = frame.hostLightIntensity[i].rgb * light.skyIrradiance.w;
    vec3 irradiance = intensity * (inverse * inverse);
    lit.mirrored += mirroredLight(sea, seen, v, l, irradiance, ball.w * inverse, intensity / (kPi * ball.w * ball.w),
                                  true);
    lit.entering += enteringIrradiance(irradiance, l.y, vec3(0));
    lit.foam += irradiance * max(dot(sea.normal, l), 0.0);
  } while (++i < frame.hostLights);
  return lit;
}

#endif
