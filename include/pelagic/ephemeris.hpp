/// Where sun, moon and stars stand over a place on the sea, by date and time: plain CPU functions in double precision.
/// World axes are those of Pelagic, with +x toward the east, +y up and +z toward the south (x × y = z), so that -z is
/// north. An azimuth, from +x turning to +z, is a compass bearing less pi/2: 0 east, pi/2 south, pi west, -pi/2 north.
/// Sources: Meeus, Astronomical Algorithms (1998), ch. 12, 21, 25, 47 and 48; Morrison & Stephenson (2004).
#pragma once

#include <glm/glm.hpp>
#include <pelagic/result.hpp>

namespace pelagic {

/// A moment in UTC and the Gregorian calendar. UTC is read as UT1: off by 0.9 s, or 0.004 degrees of sky, at most.
struct CivilTime {
  int year = 2000;    ///< 1800 … 2200.
  int month = 6;      ///< 1 … 12.
  int day = 21;       ///< 1 … the last of the month.
  double hours = 12;  ///< Since midnight [h], 0 … 24, 24 itself excluded.
};

/// A place at sea level.
struct Place {
  double latitude = 0;   ///< Geographic, north positive [rad], -pi/2 … pi/2.
  double longitude = 0;  ///< East positive [rad], finite.
};

/// Directions are those of the centres as seen from the place, so with parallax, and geometric: the sky that Pelagic
/// draws does not refract. Real air lifts what is seen on the horizon by 0.57 degrees, at 10 degrees by 0.09. Errors
/// are those against a full theory from 1800 to 2026, later but for how the Earth's rotation will slow.
struct Celestial {
  double sunElevation = 0;     ///< [rad], -pi/2 … pi/2, off by 0.011 degrees at most.
  double sunAzimuth = 0;       ///< [rad], -pi … pi, off by as much across the line of sight.
  double moonElevation = 0;    ///< [rad], -pi/2 … pi/2, off by 0.04 degrees at most.
  double moonAzimuth = 0;      ///< [rad], -pi … pi, off by as much across the line of sight.
  double moonIlluminated = 0;  ///< Part of the moon's disc that the sun lights [1], 0 new … 1 full. Eclipses apart.
  double moonDistance = 0;     ///< To its centre [m].
  /// Turns directions of a star catalogue, equator and equinox of J2000 (x: right ascension and declination 0, z: the
  /// north pole), into the world. Off by 0.009 degrees: nutation and aberration are left out. Proper motion is the
  /// caller's.
  glm::dmat3 equatorialToWorld{1};
};

Result<void> validate(const CivilTime& time);
Result<void> validate(const Place& place);
/// Fails only on what validate() refuses.
Result<Celestial> celestial(const CivilTime& time, const Place& place);

}  // namespace pelagic
