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
    {-73000, 329.6678, 0.98909, 263.6984, -4.1279, 372369}, {-70151, 255.5356, 0.98462, 2.1990, 4.4952, 404606},
    {-67303, 181.5291, 1.00212, 81.1717, -0.6823, 379531},  {-64454, 111.1676, 1.01642, 194.4138, -5.1493, 384832},
    {-61606, 40.3396, 1.00822, 269.4021, 4.2888, 404161},   {-58757, 328.1946, 0.98867, 14.0404, 1.7046, 364001},
    {-55909, 253.0295, 0.98503, 103.4763, -4.9858, 393985}, {-53060, 180.1184, 1.00278, 194.0369, 3.2363, 386601},
    {-50212, 108.8546, 1.01654, 287.9099, 2.0415, 362255},  {-47363, 38.9418, 1.00772, 25.0293, -5.0038, 406623},
    {-34364, 248.6519, 0.98584, 312.1315, 1.0483, 383464},  {-31515, 175.9283, 1.00419, 39.2516, 3.7576, 400857},
    {-28666, 105.7483, 1.01671, 147.2559, -4.1656, 362047}, {-25818, 34.7861, 1.00628, 232.8126, -0.1442, 400130},
    {-22969, 322.3628, 0.98718, 324.7103, 4.4846, 376955},  {-20121, 247.1665, 0.98615, 60.0511, -3.8909, 368915},
    {-17272, 174.5205, 1.00484, 154.5961, -1.1985, 404534}, {-14424, 103.4434, 1.01672, 236.5081, 4.7220, 365013},
    {-11575, 33.3868, 1.00579, 347.4180, -2.7479, 395443},  {-8727, 319.8656, 0.98660, 61.9032, -1.3090, 395619},
    {1424, 242.7959, 0.98716, 264.6540, -2.9741, 359120},   {4273, 170.3554, 1.00622, 2.5685, 4.8481, 404856},
    {7121, 99.3870, 1.01672, 82.1417, -2.2771, 373019},     {9970, 29.2113, 1.00427, 191.2188, -4.0398, 378302},
    {12819, 316.4993, 0.98592, 283.8491, 4.5596, 400345},   {15667, 241.3213, 0.98750, 9.1375, -0.7181, 364413},
    {18516, 168.9615, 1.00680, 117.9292, -4.9127, 400815},  {21364, 98.0318, 1.01657, 191.7945, 4.6784, 391426},
    {24213, 27.7975, 1.00370, 302.9369, 1.8068, 374149},    {27061, 314.0003, 0.98549, 25.8522, -5.0761, 403632},
    {37212, 236.9685, 0.98865, 213.3209, -4.9327, 365615},  {40061, 164.8147, 1.00806, 323.3004, 1.8684, 387277},
    {42909, 93.9690, 1.01636, 40.5332, 2.2989, 398262},     {45758, 23.6017, 1.00221, 142.2365, -5.1551, 366793},
    {48606, 309.6123, 0.98482, 235.6412, 1.5014, 400513},   {51455, 235.5005, 0.98912, 322.1538, 3.5567, 386914},
    {54303, 162.4566, 1.00885, 62.5761, -4.8513, 373408},   {57152, 92.6101, 1.01620, 154.5903, 0.2423, 404794},
    {60001, 22.1856, 1.00157, 252.8894, 4.7584, 370410},    {62849, 308.1277, 0.98459, 347.8414, -3.7829, 383373},
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
  const double means[] = {0.00257, 2.85e-5, 0.00514, 0.00341, 15.33};
  for (int i = 0; i < 5; ++i) EXPECT_LT(std::sqrt(squares[i]), means[i]) << i;
}

}  // namespace
