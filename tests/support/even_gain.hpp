/// A map of gains that is the same everywhere.
#pragma once

#include <pelagic/gain_map.hpp>

namespace support {

inline pelagic::GainMap evenGain(float gain) {
  pelagic::GainMap map;
  map.width = map.height = 2;
  map.bands = 1;
  map.gains.assign(4, gain);
  return map;
}

}  // namespace support
