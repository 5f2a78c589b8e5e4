/// The sea as JSON: what was asked for and what became of it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "sea_options.hpp"

namespace common {

/// The document of sea.json. An infinite depth is null, JSON has no infinity.
nlohmann::ordered_json seaJson(const SeaSettings& sea, const pelagic::WaveLayout& layout,
                               const pelagic::SeaReport& report, std::span<const double> times);

}  // namespace common
