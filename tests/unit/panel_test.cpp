#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/ocean_brdf.glsl"
#include "physics/panel.glsl"

namespace {

using namespace pelagic;
using glm::dvec3;
using glm::vec2;
using glm::vec3;

/// A rectangle seen from the origin, half-axes and middle in metres.
struct Panel {
  dvec3 middle, a, b;
};

/// Calls f(direction, solid angle) for the parts of the rectangle.
template <class F>
void overPanel(const Panel& panel, int steps, F f) {
  const dvec3 n = glm::cross(panel.a, panel.b);
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const dvec3 p = panel.middle + ((2 * i + 1.0) / steps - 1) * panel.a + ((2 * j + 1.0) / steps - 1) * panel.b;
      const double r = glm::length(p);
      f(p / r, 4 * std::max(-glm::dot(n, p), 0.0) / (steps * steps * r * r * r));
    }
  }
}

vec3 irradiance(const Panel& panel) {
  const double r = glm::length(panel.middle);
  return physics::panelIrradiance(vec3(panel.middle / r), vec3(panel.a / r), vec3(panel.b / r));
}

/// Rectangles near and far, thin, and seen aslant.
std::vector<Panel> panels() {
  std::vector<Panel> result;
  for (const double far : {0.7, 2.0, 6.0, 9.9, 10.1, 50.0, 1e3, 1e5}) {
    for (const double thin : {1.0, 0.1, 0.01}) {
      for (const double aslant : {0.0, 0.5, 1.2, 1.5}) {
        // Toward -z, seen from a side that is neither axis.
        const dvec3 to = dvec3(0.8 * std::sin(aslant), 0.6 * std::sin(aslant), std::cos(aslant));
        result.push_back({far * to, {0, 1, 0}, {thin, 0, 0}});
      }
    }
  }
  return result;
}

TEST(Panel, IrradianceIsQuadratureOverTheRectangle) {
  for (const Panel& panel : panels()) {
    dvec3 expected(0);
    overPanel(panel, 600, [&](const dvec3& l, double solidAngle) { expected += solidAngle * l; });
    const double error = glm::length(dvec3(irradiance(panel)) - expected) / glm::length(expected);
    EXPECT_LT(error, 2e-3) << glm::length(panel.middle) << ' ' << panel.b.x << ' ' << panel.middle.z;
  }
}

TEST(Panel, ItsBackIsDark) {
  for (const Panel& panel : panels()) {
    EXPECT_EQ(irradiance({panel.middle, panel.b, panel.a}), vec3(0));
    EXPECT_GT(glm::length(irradiance(panel)), 0);
  }
}

TEST(Panel, ThinOnesKeepTheirDigits) {
  // A strip of 10 m x 1 cm across the distance d from its middle, over its width per distance: the integral of
  // d^2/(d^2 + x^2)^2 over its length.
  for (const double d : {2.0, 10.0, 45.0, 55.0, 1e3, 1e4}) {
    const double x = 5 / d, expected = 0.01 / d * (x / (1 + x * x) + std::atan(x));
    const vec3 seen = irradiance({{0, 0, d}, {0, 5, 0}, {0.005, 0, 0}});
    EXPECT_NEAR(seen.z / expected, 1, 2e-3) << d;
  }
}

TEST(Panel, FillsTheHalfSpaceOfAPointOnIt) {
  const vec3 seen = irradiance({{0, 0, 1e-3}, {0, 1, 0}, {1, 0, 0}});
  EXPECT_NEAR(seen.z, std::numbers::pi, 2e-3);
  EXPECT_NEAR(glm::length(vec2(seen)), 0, 1e-3);
}

TEST(Panel, CovarianceIsThatOfTheSlopesThatMirrorIt) {
  const vec3 v = glm::normalize(vec3(0.6f, 0.5f, -0.3f));
  for (const double size : {0.01, 0.05}) {
    for (const dvec3 to : {dvec3(-0.5, 0.7, 0.3), dvec3(0.3, 0.2, 0.9), dvec3(0.6, 0.9, -0.3)}) {
      const Panel panel{glm::normalize(to), size * glm::normalize(dvec3(0.2, 0.9, -0.4)),
                        0.5 * size * glm::normalize(dvec3(0.9, -0.2, 0))};
      glm::dvec2 first(0);
      dvec3 second(0);
      double parts = 0;
      for (int i = 0; i < 100; ++i) {
        for (int j = 0; j < 100; ++j) {
          const dvec3 p = panel.middle + ((2 * i + 1) / 100.0 - 1) * panel.a + ((2 * j + 1) / 100.0 - 1) * panel.b;
          const glm::dvec2 s(physics::mirrorSlope(v, vec3(glm::normalize(p))));
          first += s;
          second += dvec3(s.x * s.x, s.y * s.y, s.x * s.y);
          ++parts;
        }
      }
      first /= parts;
      second = second / parts - dvec3(first.x * first.x, first.y * first.y, first.x * first.y);
      const vec3 l(panel.middle);
      const vec2 slope = physics::mirrorSlope(v, l);
      const vec3 c = physics::panelCovariance(physics::mirrorSlopeChange(slope, v, l, vec3(panel.a)),
                                              physics::mirrorSlopeChange(slope, v, l, vec3(panel.b)));
      EXPECT_LT(glm::length(dvec3(c) - second), (size > 0.02 ? 0.03 : 0.01) * glm::length(second)) << size << to.x;
    }
  }
}

TEST(Panel, ChangesOfTheMirrorSlopeMakeADiscsCovariance) {
  // A disc of the radius r has the variance r^2/4 along both axes across l.
  const vec3 v = glm::normalize(vec3(0.6f, 0.5f, -0.3f)), l = glm::normalize(vec3(-0.2f, 0.4f, 0.8f));
  const vec3 a = glm::normalize(glm::cross(l, v)), b = glm::cross(l, a);
  const vec2 slope = physics::mirrorSlope(v, l);
  const float radius = 0.1f, scale = radius * std::sqrt(3.0f) / 2;
  const vec3 panel = physics::panelCovariance(physics::mirrorSlopeChange(slope, v, l, scale * a),
                                              physics::mirrorSlopeChange(slope, v, l, scale * b));
  const vec3 disc = physics::discCovariance(slope, l, glm::dot(v, glm::normalize(v + l)), radius);
  EXPECT_LT(glm::length(panel - disc), 1e-5f * glm::length(disc));
}

}  // namespace
