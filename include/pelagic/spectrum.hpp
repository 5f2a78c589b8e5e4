/// The spectra as plain CPU functions in double precision, for anyone who needs the numbers.
/// Sources and conventions: ARCHITECTURE.md, "Formulas".
#pragma once

#include <pelagic/sea_state.hpp>

namespace pelagic {

/// Up-wind and cross-wind parts of the mean square slope [1].
struct SlopeVariance {
  double upwind = 0;
  double crosswind = 0;
};

/// Angular frequency [rad/s] of a wave number k [rad/m] in water of depth h [m]:
/// w^2 = (g k + (sigma/rho) k^3) tanh(k h), sigma/rho = 7.4e-5 m^3/s^2.
double angularFrequency(double waveNumber, double depth) noexcept;
/// Group speed dw/dk [m/s].
double groupSpeed(double waveNumber, double depth) noexcept;
/// Inverse of angularFrequency: k [rad/m] for w [rad/s] > 0.
double waveNumberOf(double angularFrequency, double depth) noexcept;

/// Angular frequency of the wind sea's spectral peak [rad/s].
double peakFrequency(const SeaState& sea) noexcept;
/// S(w) of the wind sea alone [m^2 s].
double windSeaSpectrum(const SeaState& sea, double angularFrequency) noexcept;
/// S(w) of one swell train [m^2 s], scaled so that its integral is Hs^2/16.
double swellSpectrum(const Swell& swell, double angularFrequency) noexcept;
/// S(w) of everything but single trochoids [m^2 s].
double frequencySpectrum(const SeaState& sea, double angularFrequency) noexcept;
/// D(w, theta) of the wind sea [1/rad]; theta [rad] is the angle from the wind. Its integral over theta is 1.
double windSeaSpreading(const SeaState& sea, double angularFrequency, double theta) noexcept;
/// Psi(k) [m^4] of everything but single trochoids: S(w) D(w, theta) (dw/dk) / k, summed over wind sea and swell. 0 at
/// k = 0.
double waveNumberSpectrum(const SeaState& sea, double kx, double kz) noexcept;

/// Variance of the elevation m0 [m^2] carried by wave numbers in [kMin, kMax] [rad/m], by quadrature, and by the
/// single trochoids among them.
double elevationVariance(const SeaState& sea, double kMin, double kMax) noexcept;
/// Mean square slope carried by wave numbers in [kMin, kMax] [rad/m], by quadrature, along and across the wind.
SlopeVariance slopeVariance(const SeaState& sea, double kMin, double kMax) noexcept;
/// Hs = 4 sqrt(m0) [m] of the whole sea.
double significantWaveHeight(const SeaState& sea) noexcept;
/// Mean period between zero up-crossings Tz = 2 pi sqrt(m0 / m2) [s] of a point of the whole sea, m2 the variance of
/// the elevation's rate.
double zeroCrossingPeriod(const SeaState& sea) noexcept;
/// Period of the largest maximum of S(w) over wind sea and swell [s].
double peakPeriod(const SeaState& sea) noexcept;
/// Wavelength at the peak of the longest train, wind sea, swell or single trochoid [m].
double longestPeakWavelength(const SeaState& sea) noexcept;
/// Measured slopes of the real sea, Cox & Munk (1954): 0.00316 U up-wind, 0.003 + 0.00192 U across; U10 is used for
/// U12.5.
SlopeVariance coxMunkSlopes(double windSpeed) noexcept;
/// Skewness of the measured slopes along the direction the wind blows toward [1], Cox & Munk (1954): 0.04 - 0.033 U,
/// within 0.12; 0 where that is positive, and no lower beyond the 14 m/s they had. Negative: steeper in front.
double coxMunkSkewness(double windSpeed) noexcept;
/// Fraction of the surface under whitecaps, Monahan & O'Muircheartaigh (1980): 3.84e-6 U10^3.41, at most 1; none in
/// winds below 3.7 m/s, where Callaghan et al. (2008) saw none.
double whitecapFraction(double windSpeed) noexcept;

}  // namespace pelagic
