/// The sea that the caller asks for.
#pragma once

#include <cstdint>
#include <limits>
#include <pelagic/result.hpp>
#include <vector>

namespace pelagic {

/// Acceleration of gravity [m/s^2].
inline constexpr double kGravity = 9.81;

/// Frequency spectrum of the wind sea.
enum class Spectrum {
  phillips,          ///< Tessendorf (2001): exp(-1/(kL)^2)/k^4, scaled to the Hs of a fully developed sea.
  piersonMoskowitz,  ///< Pierson & Moskowitz (1964): fully developed, fetch is not used.
  jonswap,           ///< Hasselmann et al. (1973), fetch capped where the sea is fully developed.
  tma,               ///< JONSWAP x Kitaigorodskii's depth factor (Bouws et al. 1985).
};

/// Distribution of the wind sea's energy over directions.
enum class Spreading {
  cos2,           ///< (2/pi) cos^2 within 90 degrees of the wind.
  mitsuyasu,      ///< cos^2s of half the angle, Mitsuyasu et al. (1975).
  hasselmann,     ///< cos^2s of half the angle, Hasselmann et al. (1980).
  donelanBanner,  ///< sech^2, Donelan et al. (1985) with Banner's (1990) tail.
};

/// One train of swell: waves that come from a distant storm.
struct Swell {
  double significantHeight = 1;  ///< Hs of the train alone [m], > 0 … 20.
  double peakPeriod = 10;        ///< Tp [s], 1 … 30.
  double direction = 0;          ///< Travels toward, from +x turning to +z [rad], finite.
  double spread = 20;            ///< Exponent s of cos^2s of half the angle [1], 1 … 200; larger is narrower.
};

/// A sea state. Lengths in metres, times in seconds, angles in radians.
struct SeaState {
  double windSpeed = 8;                                    ///< U10, at 10 m height [m/s], 0.1 … 60.
  double windDirection = 0;                                ///< Blows toward, from +x turning to +z [rad], finite.
  double fetch = 100e3;                                    ///< Distance over which the wind blows [m], 100 … 1e7.
  double depth = std::numeric_limits<double>::infinity();  ///< Water depth [m], 0.5 … infinity.
  Spectrum spectrum = Spectrum::jonswap;
  Spreading spreading = Spreading::hasselmann;
  double choppiness = 1;  ///< Horizontal displacement, 1 is physical [1], 0 … 2.
  std::vector<Swell> swell;
  std::uint64_t seed = 1;  ///< Any; the same seed gives the same sea on every machine.
};

/// Checks every field. The error names the field, its value and its range.
Result<void> validate(const SeaState& sea);

}  // namespace pelagic
