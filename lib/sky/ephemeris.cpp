#include <pelagic/shader/constants.h>

#include <chrono>
#include <cmath>
#include <gpu/context.hpp>
#include <numbers>
#include <pelagic/ephemeris.hpp>
#include <sky/orbits.hpp>
#include <sstream>

namespace pelagic {
namespace {

/// Written so that NaN fails.
Result<void> check(const char* field, double value, double low, double high, const std::string& range) {
  if (value >= low && value <= high) return {};
  std::ostringstream text;
  text << field << " is " << value << ", it must be " << range;
  return gpu::reject(text.str());
}

/// Of universal time since J2000.0, noon of the first of January.
double daysSinceEpoch(const CivilTime& time) {
  using namespace std::chrono;
  const sys_days date = year(time.year) / time.month / time.day;
  return static_cast<double>((date - sys_days(2000y / January / 1)).count()) + time.hours / 24 - 0.5;
}

double elevation(const glm::dvec3& toward) { return std::atan2(toward.y, std::hypot(toward.x, toward.z)); }
double azimuth(const glm::dvec3& toward) { return std::atan2(toward.z, toward.x); }

}  // namespace

Result<void> validate(const CivilTime& time) {
  PELAGIC_CHECK(check("CivilTime::year", time.year, 1800, 2200, "1800 to 2200"));
  PELAGIC_CHECK(check("CivilTime::month", time.month, 1, 12, "1 to 12"));
  const auto last = (std::chrono::year(time.year) / time.month / std::chrono::last).day();
  const unsigned days = static_cast<unsigned>(last);
  PELAGIC_CHECK(check("CivilTime::day", time.day, 1, days, "1 to " + std::to_string(days) + " in that month"));
  return check("CivilTime::hours", time.hours, 0, std::nextafter(24, 0), "0 to 24, 24 itself excluded");
}

Result<void> validate(const Place& place) {
  constexpr double kPole = std::numbers::pi / 2, kAny = std::numeric_limits<double>::max();
  PELAGIC_CHECK(check("Place::latitude", place.latitude, -kPole, kPole, "-pi/2 to pi/2"));
  return check("Place::longitude", place.longitude, -kAny, kAny, "finite");
}

Result<Celestial> celestial(const CivilTime& time, const Place& place) {
  PELAGIC_CHECK(validate(time));
  PELAGIC_CHECK(validate(place));
  const double days = daysSinceEpoch(time);
  const double centuries = (days + terrestrialLead(days) / 86400) / 36525;
  const glm::dmat3 toWorld = horizon(siderealTime(days) + place.longitude, place.latitude);
  // The Earth's flattening would move the moon by 0.003 degrees.
  const glm::dvec3 observer(0, shader::kEarthRadius, 0);
  const glm::dvec3 sun = toWorld * equatorial(sunAt(centuries), centuries) - observer;
  const glm::dvec3 moon = toWorld * equatorial(moonAt(centuries), centuries) - observer;
  return Celestial{elevation(sun),
                   azimuth(sun),
                   elevation(moon),
                   azimuth(moon),
                   illuminatedFraction(moon, sun),
                   glm::length(moon),
                   toWorld * precession(centuries)};
}

}  // namespace pelagic
