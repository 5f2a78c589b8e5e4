/// The sea as a user asks for it: options shared by all programs.
#pragma once

#include <pelagic/waves.hpp>

#include "field.hpp"

namespace common {

/// Everything that defines a simulation.
struct SeaSettings {
  pelagic::SeaState state;
  pelagic::GainMap gain;
  double loopPeriod = 4194304;  ///< [s]
  std::uint32_t cascades = 4;
  double span = 0;  ///< Least length of the longest cascade [m].
  double warp = pelagic::WavesInfo().warp;
  std::uint32_t size = 256;  ///< Samples along each side of a cascade.
};

/// Setters of `sea`, which must outlive them.
Fields seaFields(SeaSettings& sea);
/// Throws a Failure when the library refuses the combination.
pelagic::WavesInfo wavesInfo(const SeaSettings& sea, pelagic::MapPrecision precision);

const Choices<pelagic::Spectrum>& spectra();
const Choices<pelagic::Spreading>& spreadings();
/// The name of a value, as the user types it.
template <class T>
std::string_view nameOf(const Choices<T>& choices, T value) {
  for (const auto& choice : choices) {
    if (choice.second == value) return choice.first;
  }
  return {};
}

}  // namespace common
