/// The motions behind include/pelagic/ephemeris.hpp, after Meeus, Astronomical Algorithms (1998). Equator, ecliptic and
/// equinox are the mean ones of date: nutation, which is left out, turns the sky by 0.003 degrees at most.
#pragma once

#include <glm/glm.hpp>

namespace pelagic {

/// As seen from the centre of the Earth.
struct Ecliptic {
  double longitude;  ///< [rad], any turn.
  double latitude;   ///< [rad].
  double distance;   ///< [m].
};

/// Apparent but for nutation. Time is in centuries of 36525 days of terrestrial time since J2000.0.
Ecliptic sunAt(double centuries) noexcept;
Ecliptic moonAt(double centuries) noexcept;
/// Equatorial position [m]: x toward the equinox, z toward the north pole.
glm::dvec3 equatorial(const Ecliptic& position, double centuries) noexcept;

/// From the equator and equinox of J2000.0 to those of date.
glm::dmat3 precession(double centuries) noexcept;
/// From the equator and equinox of date to the world's east, up and south.
glm::dmat3 horizon(double localSiderealTime, double latitude) noexcept;

/// Mean sidereal time of Greenwich [rad], `days` of universal time after J2000.0.
double siderealTime(double days) noexcept;
/// Terrestrial time less universal time [s].
double terrestrialLead(double days) noexcept;

/// Part of the moon's disc that is lit [1], for positions as seen from the same point.
double illuminatedFraction(const glm::dvec3& moon, const glm::dvec3& sun) noexcept;

}  // namespace pelagic
