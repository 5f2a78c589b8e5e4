/// Measured spectra as CSV files.
#pragma once

#include <pelagic/sea_state.hpp>
#include <string>

namespace common {

/// Rows `f,S` [Hz, m^2/Hz]; or a first row `f,DEG,DEG,…` of directions toward which waves travel, from +x turning to
/// +z, and rows `f,S,S,…` [Hz, m^2/(Hz rad)]. Empty lines and lines that start with # are skipped. Throws a Failure
/// that names file, line and value.
pelagic::SpectrumTable readSpectrum(const std::string& where, const std::string& path);

}  // namespace common
