/// The series and frames under pelagic/ephemeris.hpp, against the worked examples of Meeus, Astronomical Algorithms
/// (1998), and a full theory.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sky/orbits.hpp>

namespace {

using namespace pelagic;
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kAstronomicalUnit = 1.495978707e11;  // [m]

/// A number of turns apart [degrees].
double apart(double radians, double degrees) { return std::remainder(radians / kDegree - degrees, 360); }

glm::dvec3 toward(double rightAscension, double declination) {
  const double a = rightAscension * kDegree, d = declination * kDegree;
  return {std::cos(d) * std::cos(a), std::cos(d) * std::sin(a), std::sin(d)};
}

void expectToward(const glm::dvec3& direction, double rightAscension, double declination, double within) {
  const glm::dvec3 unit = glm::normalize(direction);
  EXPECT_NEAR(std::asin(unit.z) / kDegree, declination, within);
  EXPECT_NEAR(apart(std::atan2(unit.y, unit.x), rightAscension), 0, within);
}

// Example 25.a, 1992 October 13.0 TD. It gives the true longitude; the sun is seen 0.00569 degrees behind it.
TEST(Orbits, SunOfMeeus) {
  const Ecliptic sun = sunAt(-0.072183436);
  EXPECT_NEAR(apart(sun.longitude, 199.90988 - 0.00569), 0, 2e-5);
  EXPECT_EQ(sun.latitude, 0);
  EXPECT_NEAR(sun.distance / kAstronomicalUnit, 0.99766, 5e-6);
}

// Example 47.a, 1992 April 12.0 TD, without the terms that are left out.
TEST(Orbits, MoonOfMeeus) {
  const Ecliptic moon = moonAt(-0.077221081451);
  EXPECT_NEAR(apart(moon.longitude, 133.162655), 0, 0.02);
  EXPECT_NEAR(moon.latitude / kDegree, -3.229126, 0.02);
  EXPECT_NEAR(moon.distance, 368409.7e3, 50e3);
}

// The same examples' apparent places, from their longitudes with nutation. The obliquity has 0.0003 degrees of it.
TEST(Orbits, EquatorialCoordinatesOfMeeus) {
  const double au = kAstronomicalUnit;
  const glm::dvec3 sun = equatorial({199.90895 * kDegree, 0, au}, -0.072183436);
  expectToward(sun, 198.38083, -7.78507, 3e-4);
  EXPECT_NEAR(glm::length(sun) / au, 1, 1e-12);
  expectToward(equatorial({133.167265 * kDegree, -3.229126 * kDegree, 1}, -0.077221081451), 134.688470, 13.768368,
               1e-3);
}

// Examples 12.a and 12.b: 1987 April 10 at 0h and at 19h 21m.
TEST(Orbits, SiderealTimeOfMeeus) {
  EXPECT_NEAR(apart(siderealTime(2446895.5 - 2451545), 197.693195), 0, 1e-6);
  EXPECT_NEAR(apart(siderealTime(2446896.30625 - 2451545), 128.7378734), 0, 1e-6);
  // The term in the centuries squared, a hundred years after the epoch.
  const double mean = 280.46061837 + std::remainder(360.98564736629 * 36525, 360);
  EXPECT_NEAR(apart(siderealTime(36525), mean), 3.87933e-4, 1e-8);
}

// Example 21.b: theta Persei from J2000.0 to 2028 November 13.19 TD.
TEST(Orbits, PrecessionOfMeeus) {
  const double centuries = 0.288670500;
  expectToward(precession(centuries) * toward(41.054063, 49.227750), 41.547214, 49.348483, 2e-6);
  EXPECT_EQ(precession(0), glm::dmat3(1));
}

// Lieske's polynomials turn the pole by theta = 2004.3109 t - 0.42665 t^2 - 0.041833 t^3 arc seconds, the equinox by
// zeta + z about it.
TEST(Orbits, PrecessionOfTwoCenturies) {
  for (const double t : {-2.0, 2.0}) {
    const double theta = 2004.3109 * t - 0.42665 * t * t - 0.041833 * t * t * t;
    const double both = 2 * 2306.2181 * t + (0.30188 + 1.09468) * t * t + (0.017998 + 0.018203) * t * t * t;
    const glm::dmat3 turn = precession(t);
    EXPECT_NEAR(std::acos(turn[2][2]) / kDegree * 3600, std::abs(theta), 1e-6);
    // A turn by zeta and z about the pole and theta across it, of trace (1 + cos theta)(1 + cos(zeta + z)) - 1.
    const double trace = turn[0][0] + turn[1][1] + turn[2][2];
    EXPECT_NEAR(trace, (1 + std::cos(theta * kDegree / 3600)) * (1 + std::cos(both * kDegree / 3600)) - 1, 1e-12);
    // The old pole stands at right ascension pi + z of date, where theta is positive.
    const glm::dvec3 pole = turn * glm::dvec3(0, 0, 1);
    const double z = 2306.2181 * t + 1.09468 * t * t + 0.018203 * t * t * t;
    const double side = t > 0 ? 180 : 0;
    EXPECT_NEAR(apart(std::atan2(pole.y, pole.x), side + z / 3600) * 3600, 0, 1e-6);
  }
}

// Example 13.b: Venus over Washington, 1987 April 10 at 19h 21m UT. Meeus counts azimuth from the south to the west.
TEST(Orbits, HorizonOfMeeus) {
  const double hourAngle = 64.352133, rightAscension = 347.3193375;
  const glm::dmat3 toWorld = horizon((rightAscension + hourAngle) * kDegree, 38.9213889 * kDegree);
  const glm::dvec3 venus = toWorld * toward(rightAscension, -6.719892);
  EXPECT_NEAR(std::asin(venus.y) / kDegree, 15.1249, 1e-4);
  EXPECT_NEAR(std::atan2(venus.z, venus.x) / kDegree, 68.0337 + 90, 1e-4);
}

// Example 48.a, where the centre of the Earth sees it.
TEST(Orbits, IlluminatedFractionOfMeeus) {
  const glm::dvec3 moon = 368410e3 * toward(134.6885, 13.7684), sun = 149971520e3 * toward(20.6579, 8.6964);
  EXPECT_NEAR(illuminatedFraction(moon, sun), 0.6786, 5e-5);
  EXPECT_NEAR(illuminatedFraction({4e8, 0, 0}, {1.5e11, 0, 0}), 0, 1e-9);
  EXPECT_NEAR(illuminatedFraction({-4e8, 0, 0}, {1.5e11, 0, 0}), 1, 1e-9);
}

// Observed until 2020, Meeus's ch. 10 and the leap seconds; the forecast of Espenak & Meeus (2006) for 2150.
TEST(Orbits, TerrestrialTimeLeadsAsTheEarthSlows) {
  const double observed[][2] = {{1850, 7}, {1900, -3}, {1950, 29}, {1980, 51}, {2000, 64}, {2020, 69}};
  for (const auto& [year, lead] : observed) EXPECT_NEAR(terrestrialLead((year - 2000) * 365.25), lead, 40) << year;
  EXPECT_NEAR(terrestrialLead(150 * 365.25), 328, 5);
}

/// Days of terrestrial time since J2000.0, the sun's longitude and distance [degrees, AU], the moon's longitude,
/// latitude and distance [degrees, km], apparent but for nutation, mean ecliptic and equinox of date: by ERFA 2.0.0,
/// epv00 and moon98.
struct Reference {
  double days, sun, sunDistance, moon, moonLatitude, moonDistance;
};
constexpr Reference kReference[] = {
    {-71576, 292.1799, 0.98365, 299.7235, -1.3017, 382116}, {-68727, 218.1909, 0.99177, 48.8593, -4.5497, 368325},
    {-65879, 145.6104, 1.01161, 130.4384, 4.5075, 406064},  {-63030, 75.9020, 1.01525, 225.4211, 0.1177, 362017},
    {-60181, 5.1255, 0.99829, 334.6534, -5.0148, 395475},   {-57333, 290.6846, 0.98345, 50.4399, 4.1151, 393139},
    {-54484, 216.7384, 0.99233, 156.8243, 2.2204, 369845},  {-51636, 144.2332, 1.01196, 245.4402, -5.2543, 402949},
    {-48787, 74.5338, 1.01500, 334.5823, 2.9065, 381992},   {-35788, 286.2772, 0.98332, 259.5297, 3.1195, 402812},
    {-32939, 212.4402, 0.99370, 358.1063, -4.8704, 360342}, {-30091, 140.1326, 1.01299, 93.2282, 0.6353, 398120},
    {-27242, 70.4603, 1.01426, 179.7288, 4.1147, 388272},   {-24394, 358.4367, 0.99590, 276.5614, -4.5990, 372414},
    {-21545, 284.7839, 0.98329, 14.0355, -0.7485, 403983},  {-18697, 209.9903, 0.99456, 93.7030, 4.5244, 380669},
    {-15848, 138.7659, 1.01334, 206.4937, -3.1554, 381276}, {-12999, 69.0906, 1.01388, 293.7311, -1.9413, 402554},
    {0, 280.3720, 0.98333, 223.3187, 5.1713, 402445},       {2849, 206.7133, 0.99579, 310.3373, -2.2054, 383256},
    {5697, 134.6783, 1.01417, 49.9778, -3.8251, 376075},    {8546, 65.0043, 1.01297, 142.5264, 4.9245, 404394},
    {11394, 352.7052, 0.99382, 226.6735, -1.2032, 374122},  {14243, 278.8769, 0.98340, 336.4095, -4.8045, 386163},
    {17091, 204.2803, 0.99667, 52.0162, 4.6423, 401149},    {19940, 133.3198, 1.01451, 158.2246, 0.9002, 359261},
    {22788, 62.6639, 1.01236, 244.9696, -4.5911, 400865},   {38636, 200.0357, 0.99822, 259.5336, 1.9362, 405094},
    {41485, 129.2431, 1.01511, 0.2175, -5.1623, 367905},    {44334, 59.5201, 1.01154, 105.8315, 0.8910, 391622},
    {47182, 346.9426, 0.99186, 182.0476, 2.9927, 394429},   {50031, 272.9839, 0.98374, 290.3408, -4.5337, 360040},
    {52879, 198.6012, 0.99877, 15.0151, 0.8964, 405058},    {55728, 127.8802, 1.01539, 107.1945, 3.9782, 368848},
    {58576, 57.1798, 1.01087, 203.5928, -4.4565, 379978},   {61425, 345.4824, 0.99144, 295.5773, -0.1593, 400475},
};

// Bounds on the mean are what the terms left out make, and little more: no term may have a wrong sign.
TEST(Orbits, FourCenturiesOfAFullTheory) {
  double squares[5] = {};
  for (const Reference& row : kReference) {
    const Ecliptic sun = sunAt(row.days / 36525), moon = moonAt(row.days / 36525);
    const double errors[] = {apart(sun.longitude, row.sun), sun.distance / kAstronomicalUnit - row.sunDistance,
                             apart(moon.longitude, row.moon), moon.latitude / kDegree - row.moonLatitude,
                             moon.distance / 1e3 - row.moonDistance};
    const double largest[] = {0.01, 1e-4, 0.025, 0.025, 55};
    for (int i = 0; i < 5; ++i) {
      EXPECT_LT(std::abs(errors[i]), largest[i]) << row.days << ' ' << i;
      squares[i] += errors[i] * errors[i] / std::size(kReference);
    }
  }
  const double means[] = {0.0032, 3e-5, 0.0052, 0.0051, 15.5};
  for (int i = 0; i < 5; ++i) EXPECT_LT(std::sqrt(squares[i]), means[i]) << i;
}

}  // namespace
