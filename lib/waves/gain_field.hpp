/// A gain map as the CPU looks it up, and its largest value.
#pragma once

#include <array>
#include <pelagic/waves.hpp>

namespace pelagic {

/// Gain of a cascade at a point, and its slope [1/m].
struct Gain {
  float value = 1;
  float alongX = 0;
  float alongZ = 0;
};

/// `map` must be valid. 1 everywhere where it is empty.
Gain gainAt(const GainMap& map, std::uint32_t cascade, const glm::dvec2& point) noexcept;
/// 1 where it is empty.
double largestGain(const GainMap& map) noexcept;

}  // namespace pelagic
