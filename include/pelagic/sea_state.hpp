/// The sea that the caller asks for.
#pragma once

#include <array>
#include <cstddef>
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
  elfouhaily,        ///< Elfouhaily et al. (1997): from the longest wind wave down to capillaries, with their slopes.
  table,             ///< As measured: SeaState::table.
};

/// Distribution of the wind sea's energy over directions.
enum class Spreading {
  cos2,           ///< (2/pi) cos^2 within 90 degrees of the wind.
  mitsuyasu,      ///< cos^2s of half the angle, Mitsuyasu et al. (1975).
  hasselmann,     ///< cos^2s of half the angle, Hasselmann et al. (1980).
  donelanBanner,  ///< sech^2, Donelan et al. (1985) with Banner's (1990) tail.
  elfouhaily,     ///< 1 + Delta cos 2 theta within 90 degrees of the wind, Elfouhaily et al. (1997).
};

/// Octaves of wavelength that SeaState::octaveGain tells apart, from 512 m down to 0.25 m.
inline constexpr std::size_t kOctaves = 12;

/// One train of swell: waves that come from a distant storm.
struct Swell {
  double significantHeight = 1;  ///< Hs of the train alone [m], > 0 … 20.
  double peakPeriod = 10;        ///< Tp [s], 1 … 30.
  double direction = 0;          ///< Travels toward, from +x turning to +z [rad], finite.
  double spread = 20;            ///< Exponent s of cos^2s of half the angle [1], 1 … 200; larger is narrower.
};

/// One Gerstner wave: the water moves on ellipses, h = A cos(k x - w t + phase), D = -Q A sin(k x - w t + phase) along
/// the wave, so that crests are sharper than troughs. It is one mode of a patch: Waves::trochoids() tells what the
/// nearest free mode has made of wavelength and direction, by half a mode each way at most where modes are free.
struct Trochoid {
  double amplitude = 0.5;  ///< A [m], half of its height; 1e-6 … 20.
  double wavelength = 50;  ///< [m], more than the shortest wave of the layout, at most its longest patch.
  double direction = 0;    ///< Travels toward, from +x turning to +z [rad], finite.
  double steepness = 1;    ///< Q [1], 0 … 100; 1: circles, as in deep water; 1/(k A) would be cusps.
  double phase = 0;        ///< At the origin at time 0 [rad], finite; 0: a crest.
};

/// Long waves drawn by few trochoids instead of many random ones, as artists like them. Each of `count` trochoids is
/// taken from an equal part of the spectrum's energy, up to 95 % of it from the longest waves on, and inherits what
/// random waves of its mode have left; Hs stays.
struct TrochoidPick {
  std::uint32_t count = 0;  ///< 0 … 256; 0: none.
  double roughness = 0;     ///< Share of that energy that stays in random waves [1], 0 … 1.
  double steepness = 0.8;   ///< Sum of Q k A of those picked [1], 0 … 1: 0 are round waves; held as all trochoids'.
};

/// A measured frequency spectrum, as buoys and wave models publish it; linear between its entries. Below the lowest
/// frequency there is nothing, above the highest the density falls as f^-5 (Phillips 1958): end with 0 for no such
/// tail.
struct SpectrumTable {
  std::vector<double> frequency;  ///< f [Hz], rising, 1e-3 … 50; 2 … 4096 entries.
  /// Directions the waves travel toward, from +x turning to +z [rad], rising, within one turn; 3 … 720 entries. Or
  /// empty: the density is that of all directions together, which SeaState::spreading spreads about the wind.
  std::vector<double> direction;
  /// S(f) [m^2/Hz], one a frequency; or S(f, theta) [m^2/(Hz rad)], of every frequency all directions. >= 0, not all 0.
  std::vector<double> density;
};

/// A sea state. Lengths in metres, times in seconds, angles in radians.
struct SeaState {
  double windSpeed = 8;                                    ///< U10, at 10 m height [m/s], 0.1 … 60.
  double windDirection = 0;                                ///< Blows toward, from +x turning to +z [rad], finite.
  double fetch = 100e3;                                    ///< Distance over which the wind blows [m], 100 … 1e7.
  double depth = std::numeric_limits<double>::infinity();  ///< Water depth [m], 0.5 … infinity.
  Spectrum spectrum = Spectrum::jonswap;
  Spreading spreading = Spreading::hasselmann;
  /// Narrows the wind sea toward swell, most of all its long waves: adds 16 tanh(w_p/w) xi^2 to the exponent s of
  /// cos^2s of half the angle, or multiplies another spreading by such a cosine; not the directions of a table; xi, 0 …
  /// 1 (Horvath 2015).
  double swellSharpening = 0;
  SpectrumTable table;  ///< With Spectrum::table; fetch is not used then.
  /// For artists: factor on the amplitude of waves about 512, 256, … 0.25 m long, linear over the octaves between, the
  /// same beyond the ends [1], 0 … 10. Everything computed from the sea includes it but windSeaSpectrum() and
  /// swellSpectrum(). 1 is physical.
  std::array<double, kOctaves> octaveGain{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
  double choppiness = 1;  ///< Horizontal displacement, 1 is physical [1], 0 … 2.
  /// How far the waves of the wind lean forward, steeper in front than behind [1], 0 … 2. 0: the linear theory's
  /// symmetric crests; 1: such that slopes along the wind with the deviation Cox & Munk measured would be as skewed as
  /// theirs, coxMunkSkewness(), in deep water with choppiness 1; of slopes with less than that the skewness is less in
  /// proportion. Breaking moves from crests to front faces with it. `swell` and trochoids do not lean, a table does.
  double asymmetry = 0;
  std::vector<Swell> swell;
  /// Single waves, at most 256. Each takes the place of the random waves of its mode. The sum of Q k A of all trochoids
  /// is held at 1 / (1 + 4.6 WavesInfo::warp) at most, so that no crest loops where the warp shortens waves most:
  /// SeaReport::steepnessScale. `choppiness` does not act on them.
  std::vector<Trochoid> trochoids;
  TrochoidPick trochoidPick;
  std::uint64_t seed = 1;  ///< Any; the same seed gives the same sea on every machine.
};

/// When a new sea takes over. From `start` on its amplitudes grow as those of the old one fade, with the same random
/// numbers and phases, along a polynomial without a jump in speed or acceleration; before that the sea is the old one,
/// after it the new one alone, at whatever time one looks.
struct SeaTransition {
  double start = 0;    ///< On the clock of record() [s], finite.
  double seconds = 0;  ///< 0 … 1e6 [s]; 0: the new sea is there at once and at all times.
};

/// Checks every field. The error names the field, its value and its range.
Result<void> validate(const SeaState& sea);

}  // namespace pelagic
