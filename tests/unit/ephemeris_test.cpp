/// Sun, moon and stars over known places at known events. Times of eclipses, seasons and phases: NASA's and the US
/// Naval Observatory's tables.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <pelagic/ephemeris.hpp>
#include <sky/orbits.hpp>

namespace {

using namespace pelagic;
constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180;

CivilTime at(int year, int month, int day, double hours, double minutes = 0, double seconds = 0) {
  return {year, month, day, hours + minutes / 60 + seconds / 3600};
}

Celestial over(const CivilTime& time, double latitude, double longitude) {
  return celestial(time, {latitude * kDegree, longitude * kDegree}).value();
}

glm::dvec3 toward(double elevation, double azimuth) {
  return {std::cos(elevation) * std::cos(azimuth), std::sin(elevation), std::cos(elevation) * std::sin(azimuth)};
}
glm::dvec3 sunOf(const Celestial& sky) { return toward(sky.sunElevation, sky.sunAzimuth); }
glm::dvec3 moonOf(const Celestial& sky) { return toward(sky.moonElevation, sky.moonAzimuth); }

/// Degrees between two directions.
double between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) / kDegree;
}

TEST(Ephemeris, EastUpAndSouthAreRightHanded) {
  const glm::dvec3 east = toward(0, 0), south = toward(0, kPi / 2);
  EXPECT_NEAR(glm::length(glm::cross(east, glm::dvec3(0, 1, 0)) - south), 0, 1e-12);
}

// At the north pole the sun is as high as its declination, less its parallax of 0.0024 degrees.
TEST(Ephemeris, SeasonsBegin) {
  EXPECT_NEAR(over(at(2024, 3, 20, 3, 6), 90, 0).sunElevation / kDegree, 0, 0.005);
  EXPECT_NEAR(over(at(2024, 6, 20, 20, 51), 90, 0).sunElevation / kDegree, 23.436, 0.005);
  EXPECT_NEAR(over(at(2024, 9, 22, 12, 44), 90, 0).sunElevation / kDegree, 0, 0.005);
  EXPECT_NEAR(over(at(2024, 12, 21, 9, 20), 90, 0).sunElevation / kDegree, -23.436, 0.005);
  EXPECT_NEAR(over(at(1900, 3, 21, 1, 39), 90, 0).sunElevation / kDegree, 0, 0.005);
}

// 3 November, when the sun is 16 min 25 s before the clock.
TEST(Ephemeris, NoonIsSouthInTheNorthAndNorthInTheSouth) {
  const CivilTime noonOfGreenwich = at(2024, 11, 3, 11, 43, 35), noonOfSydney = at(2024, 11, 3, 1, 38, 45);
  const double declination = over(noonOfGreenwich, 90, 0).sunElevation / kDegree;
  EXPECT_NEAR(declination, -15.3, 0.03);
  const Celestial greenwich = over(noonOfGreenwich, 51.4779, 0);
  EXPECT_NEAR(greenwich.sunAzimuth / kDegree, 90, 0.03);
  EXPECT_NEAR(greenwich.sunElevation / kDegree, 90 - 51.4779 + declination, 0.005);
  const Celestial sydney = over(noonOfSydney, -33.87, 151.21);
  EXPECT_NEAR(sydney.sunAzimuth / kDegree, -90, 0.1);
  EXPECT_NEAR(sydney.sunElevation / kDegree, 90 - 33.87 - over(noonOfSydney, 90, 0).sunElevation / kDegree, 0.005);
}

// The sun crosses Greenwich at 12:07:26 on the day of the equinox. By sunset its declination is 0.3 degrees.
TEST(Ephemeris, TheSunRisesInTheEastAndSetsInTheWest) {
  for (const double longitude : {0.0, 60.0, -75.0}) {
    const auto sun = [&](double hours) { return over(at(2024, 3, 20, hours - longitude / 15, 7, 26), 0, longitude); };
    EXPECT_NEAR(sun(6).sunElevation / kDegree, 0, 0.07) << longitude;
    EXPECT_NEAR(sun(6).sunAzimuth / kDegree, 0, 0.2) << longitude;
    EXPECT_NEAR(sun(7).sunElevation / kDegree, 15, 0.07) << longitude;
    EXPECT_NEAR(sun(18).sunElevation / kDegree, 0, 0.07) << longitude;
    EXPECT_NEAR(std::abs(sun(18).sunAzimuth) / kDegree, 180, 0.4) << longitude;
  }
  // North of the equator it goes on toward the south.
  EXPECT_GT(over(at(2024, 3, 20, 9), 45, 0).sunAzimuth, 0.3);
}

TEST(Ephemeris, LongitudesATurnApartAreOnePlace) {
  const Celestial a = over(at(2024, 5, 6, 7), 20, -170), b = over(at(2024, 5, 6, 7), 20, 190);
  EXPECT_NEAR(between(sunOf(a), sunOf(b)), 0, 1e-9);
  EXPECT_NEAR(between(moonOf(a), moonOf(b)), 0, 1e-9);
}

// At greatest eclipse, where the axis of the moon's shadow meets the Earth: the moon covers the sun only with its
// parallax, up to 0.95 degrees. The third is with the sun 15 degrees high.
TEST(Ephemeris, TheMoonCoversTheSunInTotalEclipses) {
  struct Eclipse {
    CivilTime time;
    double latitude, longitude, sunElevation;
  };
  const Eclipse eclipses[] = {
      {at(2017, 8, 21, 18, 25, 32), 36.97, -87.67, 63.9},
      {at(2024, 4, 8, 18, 17, 18), 25.29, -104.14, 69.8},
      {at(2003, 11, 23, 22, 49, 17), -72.67, 88.42, 14.9},
      {at(1919, 5, 29, 13, 8, 35), 4.42, -16.67, 73},
  };
  for (const Eclipse& eclipse : eclipses) {
    const Celestial sky = over(eclipse.time, eclipse.latitude, eclipse.longitude);
    EXPECT_LT(between(sunOf(sky), moonOf(sky)), 0.05) << eclipse.time.year;
    EXPECT_NEAR(sky.sunElevation / kDegree, eclipse.sunElevation, 0.6) << eclipse.time.year;
    EXPECT_LT(sky.moonIlluminated, 1e-6) << eclipse.time.year;
  }
  EXPECT_NEAR(over(eclipses[0].time, 36.97, -87.67).sunAzimuth / kDegree, 197.9 - 90, 0.5);
}

// Total lunar eclipse of 2018 July 27, 20:21:44 UT, where the moon is in the zenith: no parallax turns it.
TEST(Ephemeris, TheFullMoonStandsOppositeToTheSun) {
  const Celestial sky = over(at(2018, 7, 27, 20, 21, 44), -19.1, 56.1);
  EXPECT_GT(sky.moonElevation / kDegree, 89.5);
  EXPECT_LT(sky.sunElevation / kDegree, -89.5);
  EXPECT_NEAR(between(sunOf(sky), moonOf(sky)), 180 - 0.107, 0.02);  // it passes 0.1168 Earth radii from the axis
  EXPECT_GT(sky.moonIlluminated, 0.99999);
  const double centuries = (6782.3484 + 69.0 / 86400) / 36525;
  EXPECT_NEAR(moonAt(centuries).distance - sky.moonDistance, 6371e3, 2e3);
}

// The four phases of September 2024, over the sea; parallax shifts the quarters.
TEST(Ephemeris, TheMoonWaxesAndWanes) {
  EXPECT_LT(over(at(2024, 9, 3, 1, 56), 0, 0).moonIlluminated, 0.001);
  EXPECT_NEAR(over(at(2024, 9, 11, 6, 6), 0, 0).moonIlluminated, 0.5, 0.01);
  EXPECT_GT(over(at(2024, 9, 18, 2, 34), 0, 0).moonIlluminated, 0.999);
  EXPECT_NEAR(over(at(2024, 9, 24, 18, 50), 0, 0).moonIlluminated, 0.5, 0.01);
  EXPECT_NEAR(over(at(2024, 9, 7, 12), 0, 0).moonIlluminated, 0.17, 0.02);
}

TEST(Ephemeris, TheStarsTurnIsARotation) {
  for (const int year : {1800, 1999, 2200}) {
    const glm::dmat3 turn = over(at(year, 12, 31, 23.99), -47, 123).equatorialToWorld;
    const glm::dmat3 unit = glm::transpose(turn) * turn;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(unit[i][j], i == j ? 1 : 0, 1e-14);
    }
    EXPECT_NEAR(glm::determinant(turn), 1, 1e-14);
  }
}

TEST(Ephemeris, SunAndMoonStandAmongTheStars) {
  // Noon of 22 August, in days since J2000.0.
  const std::pair<int, double> years[] = {{1810, -69163}, {2000, 234}, {2190, 69630}};
  for (const auto& [year, days] : years) {
    const double centuries = (days + terrestrialLead(days) / 86400) / 36525;
    const Celestial sky = over(at(year, 8, 22, 12), 35, 20);
    const auto expected = [&, now = centuries](const Ecliptic& position) {
      const glm::dvec3 amongStars = glm::transpose(precession(now)) * equatorial(position, now);
      return sky.equatorialToWorld * amongStars - glm::dvec3(0, 6371e3, 0);
    };
    EXPECT_NEAR(between(expected(sunAt(centuries)), sunOf(sky)), 0, 1e-5) << year;
    EXPECT_NEAR(between(expected(moonAt(centuries)), moonOf(sky)), 0, 1e-5) << year;
    EXPECT_NEAR(glm::length(expected(moonAt(centuries))), sky.moonDistance, 10) << year;
  }
}

// Polaris of J2000.0: as high as the latitude, due north, within 0.74 degrees.
TEST(Ephemeris, ThePoleStarShowsNorthAndLatitude) {
  const double ra = 37.9546 * kDegree, dec = 89.2641 * kDegree;
  const glm::dvec3 polaris(std::cos(dec) * std::cos(ra), std::cos(dec) * std::sin(ra), std::sin(dec));
  for (const double hour : {0.0, 6.0, 12.0, 18.0}) {
    const Celestial sky = over(at(2000, 1, 1, hour), 50, 30);
    EXPECT_NEAR(between(sky.equatorialToWorld * polaris, toward(50 * kDegree, -kPi / 2)), 90 - 89.2641, 1e-3);
  }
}

TEST(Ephemeris, BadInputIsNamed) {
  const auto message = [](const CivilTime& time, const Place& place) {
    const auto result = celestial(time, place);
    return result ? std::string() : result.error().message;
  };
  const CivilTime now;
  EXPECT_EQ(message({1799, 1, 1, 0}, {}), "CivilTime::year is 1799, it must be 1800 to 2200");
  EXPECT_EQ(message({2201, 1, 1, 0}, {}), "CivilTime::year is 2201, it must be 1800 to 2200");
  EXPECT_EQ(message({2024, 0, 1, 0}, {}), "CivilTime::month is 0, it must be 1 to 12");
  EXPECT_EQ(message({2024, 13, 1, 0}, {}), "CivilTime::month is 13, it must be 1 to 12");
  EXPECT_EQ(message({2024, 2, 31, 0}, {}), "CivilTime::day is 31, it must be 1 to 29 in that month");
  EXPECT_EQ(message({1900, 2, 29, 0}, {}), "CivilTime::day is 29, it must be 1 to 28 in that month");
  EXPECT_EQ(message({2024, 4, 0, 0}, {}), "CivilTime::day is 0, it must be 1 to 30 in that month");
  EXPECT_EQ(message({2024, 1, 1, 24}, {}), "CivilTime::hours is 24, it must be 0 to 24, 24 itself excluded");
  EXPECT_EQ(message({2024, 1, 1, -1}, {}), "CivilTime::hours is -1, it must be 0 to 24, 24 itself excluded");
  EXPECT_EQ(message({2024, 1, 1, std::nan("")}, {}), "CivilTime::hours is nan, it must be 0 to 24, 24 itself excluded");
  EXPECT_EQ(message(now, {91 * kDegree, 0}), "Place::latitude is 1.58825, it must be -pi/2 to pi/2");
  EXPECT_EQ(message(now, {std::nan(""), 0}), "Place::latitude is nan, it must be -pi/2 to pi/2");
  EXPECT_EQ(message(now, {0, std::numeric_limits<double>::infinity()}), "Place::longitude is inf, it must be finite");
  EXPECT_EQ(message({2024, 2, 29, 23.999}, {90 * kDegree, -180 * kDegree}), "");
  EXPECT_EQ(message({1800, 1, 1, 0}, {-90 * kDegree, 400 * kDegree}), "");
}

}  // namespace
