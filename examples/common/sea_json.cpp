#include "sea_json.hpp"

#include <nlohmann/json.hpp>

namespace common {

nlohmann::ordered_json seaJson(const SeaSettings& sea, const pelagic::WaveLayout& layout,
                               const pelagic::SeaReport& report, std::span<const double> times) {
  using Json = nlohmann::ordered_json;
  Json cascades = Json::array();
  for (std::uint32_t i = 0; i < layout.count; ++i) {
    const pelagic::Cascade& cascade = layout.cascades[i];
    cascades.push_back(
        {{"length_m", cascade.length}, {"size", layout.size}, {"k_min", cascade.kMin}, {"k_max", cascade.kMax}});
  }
  return {
      {"version", PELAGIC_VERSION},
      {"seed", sea.state.seed},
      {"spectrum", sea.state.spectrum == pelagic::Spectrum::table ? "table" : nameOf(spectra(), sea.state.spectrum)},
      {"spreading", nameOf(spreadings(), sea.state.spreading)},
      {"wind_m_s", sea.state.windSpeed},
      {"wind_direction_rad", sea.state.windDirection},
      {"fetch_m", sea.state.fetch},
      {"depth_m", sea.state.depth},
      {"choppiness", sea.state.choppiness},
      {"loop_period_s", sea.loopPeriod},
      {"gravity", pelagic::kGravity},
      {"times_s", times},
      {"cascades", cascades},
      {"hs_m", {{"target", report.targetHeight}, {"grid", report.gridHeight}}},
      {"tp_s", report.peakPeriod},
      {"mss",
       {{"target_upwind", report.target.upwind},
        {"target_crosswind", report.target.crosswind},
        {"grid_upwind", report.grid.upwind},
        {"grid_crosswind", report.grid.crosswind},
        {"unresolved_upwind", report.unresolved.upwind},
        {"unresolved_crosswind", report.unresolved.crosswind}}},
      {"whitecap_fraction", report.whitecaps},
  };
}

}  // namespace common
