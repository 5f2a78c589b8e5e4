/// By how much the waves of the wind lean forward.
#pragma once

#include <pelagic/sea_state.hpp>

namespace pelagic {

/// Phase by which the horizontal displacement of a wave with the wind falls behind [rad], so that a crest of height A
/// stands choppiness coth(kh) A sin(lean) ahead of where the linear theory has it.
double leanWithWind(const SeaState& sea) noexcept;

}  // namespace pelagic
