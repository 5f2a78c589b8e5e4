/// Reading between the entries of a measured spectrum.
#pragma once

#include <pelagic/sea_state.hpp>

namespace pelagic {

/// Checks sizes, order and values; the error names the entry, its value and its range.
Result<void> validate(const SpectrumTable& table);

/// S(w) [m^2 s] over all directions, S(f)/(2 pi).
double tableSpectrum(const SpectrumTable& table, double angularFrequency) noexcept;
/// Angular frequency of the entry with the largest S [rad/s].
double tablePeak(const SpectrumTable& table) noexcept;
/// Angular frequency of the longest train [rad/s]: of the lowest peak that is a tenth of the largest or more.
double tableLongestPeak(const SpectrumTable& table) noexcept;
/// D(w, direction) [1/rad] of a table with directions, for a direction in the world; where it has no energy, even.
double tableSpreading(const SpectrumTable& table, double angularFrequency, double direction) noexcept;

}  // namespace pelagic
