#include <composite/white_balance.hpp>

namespace pelagic {
namespace {

// Columns. sRGB to CIE XYZ (IEC 61966-2-1), and XYZ to the cones' responses (Bradford, Lam 1985).
constexpr glm::dmat3 kXyzOfRgb(0.4124564, 0.2126729, 0.0193339, 0.3575761, 0.7151522, 0.1191920, 0.1804375, 0.0721750,
                               0.9503041);
constexpr glm::dmat3 kConesOfXyz(0.8951, -0.7502, 0.0389, 0.2664, 1.7135, -0.0685, -0.1614, 0.0367, 1.0296);

glm::dvec2 blackBody(double kelvin) noexcept {
  const double t = 1e3 / kelvin;
  const double x = ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910;
  const double y = kelvin < 2222 ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
                                 : ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867;
  return {x, y};
}

glm::dvec2 daylight(double kelvin) noexcept {
  const double t = 1e3 / kelvin;
  const double x = kelvin < 7000 ? ((-4.6070 * t + 2.9678) * t + 0.09911) * t + 0.244063
                                 : ((-2.0064 * t + 1.9018) * t + 0.24748) * t + 0.237040;
  return {x, (-3 * x + 2.870) * x - 0.275};
}

glm::dvec3 cones(double kelvin) noexcept {
  const glm::dvec2 white = whiteChromaticity(kelvin);
  return kConesOfXyz * glm::dvec3(white.x / white.y, 1, (1 - white.x - white.y) / white.y);
}

}  // namespace

glm::dvec2 whiteChromaticity(double kelvin) noexcept {
  const double part = glm::clamp((kelvin - 4000) / 1000, 0.0, 1.0);
  if (part >= 1) return daylight(kelvin);
  return glm::mix(blackBody(kelvin), daylight(glm::max(kelvin, 4000.0)), part);
}

glm::dmat3 whiteBalance(double kelvin) noexcept {
  const glm::dvec3 factor = cones(6504) / cones(kelvin);
  const glm::dmat3 scale(factor.x, 0, 0, 0, factor.y, 0, 0, 0, factor.z);
  const glm::dmat3 conesOfRgb = kConesOfXyz * kXyzOfRgb;
  return glm::inverse(conesOfRgb) * scale * conesOfRgb;
}

}  // namespace pelagic
