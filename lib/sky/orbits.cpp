#include <cmath>
#include <numbers>
#include <sky/orbits.hpp>

namespace pelagic {
namespace {

constexpr double kDegree = std::numbers::pi / 180;          // [rad]
constexpr double kArcSecond = kDegree / 3600;               // [rad]
constexpr double kAstronomicalUnit = 1.495978707e11;        // [m]
constexpr double kMeanDistanceOfTheMoon = 3.8500056e8;      // [m]
constexpr double kAberrationOfTheSun = -0.00569 * kDegree;  // [rad]

/// A periodic term: multiples of the arguments D, M, M' and F.
struct Term {
  glm::dvec4 multiples;
  double sine;        // of an angle [1e-6 degrees]
  double cosine = 0;  // of the distance [m]
};

// Meeus's table 47.A down to 0.0035 degrees.
constexpr Term kLongitudeAndDistance[] = {
    {{0, 0, 1, 0}, 6288774, -20905355}, {{2, 0, -1, 0}, 1274027, -3699111}, {{2, 0, 0, 0}, 658314, -2955968},
    {{0, 0, 2, 0}, 213618, -569925},    {{0, 1, 0, 0}, -185116, 48888},     {{0, 0, 0, 2}, -114332},
    {{2, 0, -2, 0}, 58793, 246158},     {{2, -1, -1, 0}, 57066, -152138},   {{2, 0, 1, 0}, 53322, -170733},
    {{2, -1, 0, 0}, 45758, -204586},    {{0, 1, -1, 0}, -40923, -129620},   {{1, 0, 0, 0}, -34720, 108743},
    {{0, 1, 1, 0}, -30383, 104755},     {{2, 0, 0, -2}, 15327, 10321},      {{0, 0, 1, 2}, -12528},
    {{0, 0, 1, -2}, 10980, 79661},      {{4, 0, -1, 0}, 10675, -34782},     {{0, 0, 3, 0}, 10034, -23210},
    {{4, 0, -2, 0}, 8548, -21636},      {{2, 1, -1, 0}, -7888, 24208},      {{2, 1, 0, 0}, -6766, 30824},
    {{1, 0, -1, 0}, -5163, -8379},      {{1, 1, 0, 0}, 4987, -16675},       {{2, -1, 1, 0}, 4036, -12831},
    {{2, 0, 2, 0}, 3994, -10445},       {{4, 0, 0, 0}, 3861, -11650},       {{2, 0, -3, 0}, 3665, 14403},
};
// Table 47.B down to 0.002 degrees.
constexpr Term kLatitude[] = {
    {{0, 0, 0, 1}, 5128122}, {{0, 0, 1, 1}, 280602},  {{0, 0, 1, -1}, 277693}, {{2, 0, 0, -1}, 173237},
    {{2, 0, -1, 1}, 55413},  {{2, 0, -1, -1}, 46271}, {{2, 0, 0, 1}, 32573},   {{0, 0, 2, 1}, 17198},
    {{2, 0, 1, -1}, 9266},   {{0, 0, 2, -1}, 8822},   {{2, -1, 0, -1}, 8216},  {{2, 0, -2, -1}, 4324},
    {{2, 0, 1, 1}, 4200},    {{2, 1, 0, -1}, -3359},  {{2, -1, -1, 1}, 2463},  {{2, -1, 0, 1}, 2211},
    {{2, -1, -1, -1}, 2065},
};

/// (47.3): of the sun, also (25.3) [rad].
double meanAnomalyOfTheSun(double t) { return kDegree * (357.5291092 + 35999.0502909 * t); }

/// Obliquity of the ecliptic, (22.2) [rad].
double obliquity(double t) { return kDegree * (23.4392911 - 0.0130042 * t); }

glm::dmat3 turnAboutX(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {1, 0, 0, 0, c, s, 0, -s, c};
}

glm::dmat3 turnAboutY(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c, 0, -s, 0, 1, 0, s, 0, c};
}

glm::dmat3 turnAboutZ(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c, s, 0, -s, c, 0, 0, 0, 1};
}

}  // namespace

// Chapter 25, low accuracy, without what comes to less than 0.0015 degrees in two centuries.
Ecliptic sunAt(double centuries) noexcept {
  const double t = centuries;
  const double anomaly = meanAnomalyOfTheSun(t);
  const double eccentricity = 0.016708634 - 4.2037e-5 * t;
  const double center = kDegree * ((1.914602 - 0.004817 * t) * std::sin(anomaly) + 0.019993 * std::sin(2 * anomaly) +
                                   2.89e-4 * std::sin(3 * anomaly));
  const double mean = kDegree * (280.46646 + 36000.76983 * t);
  const double distance =
      1.000001018 * (1 - eccentricity * eccentricity) / (1 + eccentricity * std::cos(anomaly + center));
  return {mean + center + kAberrationOfTheSun, 0, kAstronomicalUnit * distance};
}

// Chapter 47, without the same and the smallest terms. Its mean longitude has the aberration in it.
Ecliptic moonAt(double centuries) noexcept {
  const double t = centuries;
  const double mean = kDegree * (218.3164477 + t * (481267.88123421 - 1.5786e-3 * t));
  const glm::dvec4 arguments(kDegree * (297.8501921 + 445267.1114034 * t), meanAnomalyOfTheSun(t),
                             kDegree * (134.9633964 + t * (477198.8675055 + 8.7414e-3 * t)),
                             kDegree * (93.2720950 + 483202.0175233 * t));
  const double ofVenus = kDegree * 0.003958 * std::sin(kDegree * (119.75 + 131.849 * t));
  Ecliptic moon{mean + ofVenus, 0, kMeanDistanceOfTheMoon};
  for (const Term& term : kLongitudeAndDistance) {
    const double angle = glm::dot(term.multiples, arguments);
    moon.longitude += 1e-6 * kDegree * term.sine * std::sin(angle);
    moon.distance += term.cosine * std::cos(angle);
  }
  for (const Term& term : kLatitude) {
    moon.latitude += 1e-6 * kDegree * term.sine * std::sin(glm::dot(term.multiples, arguments));
  }
  return moon;
}

glm::dvec3 equatorial(const Ecliptic& position, double centuries) noexcept {
  const double across = position.distance * std::cos(position.latitude);
  return turnAboutX(obliquity(centuries)) * glm::dvec3(across * std::cos(position.longitude),
                                                       across * std::sin(position.longitude),
                                                       position.distance * std::sin(position.latitude));
}

// (21.3) and (21.4).
glm::dmat3 precession(double centuries) noexcept {
  const double t = centuries;
  const double zeta = kArcSecond * t * (2306.2181 + t * (0.30188 + 0.017998 * t));
  const double z = kArcSecond * t * (2306.2181 + t * (1.09468 + 0.018203 * t));
  const double theta = kArcSecond * t * (2004.3109 - t * (0.42665 + 0.041833 * t));
  return turnAboutZ(z) * turnAboutY(-theta) * turnAboutZ(zeta);
}

glm::dmat3 horizon(double localSiderealTime, double latitude) noexcept {
  const double c = std::cos(localSiderealTime), s = std::sin(localSiderealTime);
  const glm::dvec3 east(-s, c, 0);
  const glm::dvec3 up(std::cos(latitude) * c, std::cos(latitude) * s, std::sin(latitude));
  return glm::transpose(glm::dmat3(east, up, glm::cross(east, up)));
}

// (12.4).
double siderealTime(double days) noexcept {
  const double t = days / 36525;
  return kDegree * (280.46061837 + 360.98564736629 * days + 3.87933e-4 * t * t);
}

// The parabola of Morrison & Stephenson (2004), without the decades' fluctuations about it: 45 s from 1800 to 2025, in
// which the moon goes 0.007 degrees.
double terrestrialLead(double days) noexcept {
  const double centuries = (days / 365.25 + 2000 - 1820) / 100;
  return -20 + 32 * centuries * centuries;
}

// (48.1), with the angle between sun and observer at the moon.
double illuminatedFraction(const glm::dvec3& moon, const glm::dvec3& sun) noexcept {
  return 0.5 + 0.5 * glm::dot(glm::normalize(sun - moon), glm::normalize(-moon));
}

}  // namespace pelagic
