#include "panel.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

namespace sandbox {
namespace {

constexpr double kDegree = glm::pi<double>() / 180;  // [rad]

/// A slider over value / unit that cannot leave its range.
bool slide(const char* label, double& value, double min, double max, double unit = 1, const char* format = "%.2f",
           bool logarithmic = false) {
  double shown = value / unit;
  const ImGuiSliderFlags flags =
      ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  if (!ImGui::SliderScalar(label, ImGuiDataType_Double, &shown, &min, &max, format, flags)) return false;
  value = shown * unit;
  return true;
}

bool slide(const char* label, float& value, double min, double max, const char* format) {
  double wide = static_cast<double>(value);
  if (!slide(label, wide, min, max, 1, format, true)) return false;
  value = static_cast<float>(wide);
  return true;
}

template <class T>
bool choose(const char* label, T& value, const common::Choices<T>& choices) {
  bool changed = false;
  if (!ImGui::BeginCombo(label, std::string(common::nameOf(choices, value)).c_str())) return false;
  for (const auto& [name, choice] : choices) {
    if (ImGui::Selectable(std::string(name).c_str(), choice == value)) {
      value = choice;
      changed = true;
    }
  }
  ImGui::EndCombo();
  return changed;
}

bool drawSwell(std::vector<pelagic::Swell>& trains) {
  bool changed = false;
  for (std::size_t i = 0; i < trains.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    ImGui::Separator();
    changed |= slide("height [m]", trains[i].significantHeight, 0.01, 20, 1, "%.2f", true);
    changed |= slide("period [s]", trains[i].peakPeriod, 1, 30);
    changed |= slide("toward [deg]", trains[i].direction, -360, 360, kDegree, "%.0f");
    changed |= slide("narrowness", trains[i].spread, 1, 200, 1, "%.0f", true);
    const bool remove = ImGui::Button("Remove swell");
    ImGui::PopID();
    if (remove) {
      trains.erase(trains.begin() + static_cast<std::ptrdiff_t>(i));
      return true;
    }
  }
  if (ImGui::Button("Add swell")) {
    trains.emplace_back();
    changed = true;
  }
  return changed;
}

bool drawTrochoids(pelagic::TrochoidPick& pick) {
  const std::uint32_t none = 0, most = 64;
  bool changed = ImGui::SliderScalar("Trochoids", ImGuiDataType_U32, &pick.count, &none, &most, "%u",
                                     ImGuiSliderFlags_AlwaysClamp);
  if (pick.count == 0) return changed;
  changed |= slide("Roughness", pick.roughness, 0, 1);
  changed |= slide("Steepness", pick.steepness, 0, 1);
  return changed;
}

bool drawOctaves(std::array<double, pelagic::kOctaves>& gains) {
  if (!ImGui::TreeNode("Gain by octave")) return false;
  bool changed = false;
  for (std::size_t i = 0; i < gains.size(); ++i) {
    const std::string label = fmt::format("{} m", std::exp2(9.0 - static_cast<double>(i)));
    changed |= slide(label.c_str(), gains[i], 0, 10);
  }
  ImGui::TreePop();
  return changed;
}

bool drawDepth(double& depth) {
  bool finite = std::isfinite(depth);
  bool changed = ImGui::Checkbox("Shallow water", &finite);
  if (changed) depth = finite ? 20 : std::numeric_limits<double>::infinity();
  if (finite) changed |= slide("Depth [m]", depth, 0.5, 1000, 1, "%.1f", true);
  return changed;
}

void drawSea(common::SeaSettings& sea, Clock& clock, Changes& changes) {
  pelagic::SeaState& state = sea.state;
  bool changed = slide("Wind [m/s]", state.windSpeed, 0.1, 60, 1, "%.1f");
  changed |= slide("Wind toward [deg]", state.windDirection, -360, 360, kDegree, "%.0f");
  changed |= slide("Fetch [km]", state.fetch, 0.1, 10000, 1000, "%.1f", true);
  changed |= drawDepth(state.depth);
  changed |= choose("Spectrum", state.spectrum, common::spectra());
  changed |= choose("Spreading", state.spreading, common::spreadings());
  changed |= slide("Choppiness", state.choppiness, 0, 2);
  changed |= slide("Asymmetry", state.asymmetry, 0, 2);
  changed |= slide("Swell sharpening", state.swellSharpening, 0, 1);
  changed |= drawOctaves(state.octaveGain);
  changed |= drawSwell(state.swell);
  changed |= drawTrochoids(state.trochoidPick);
  changes.sea |= changed;
  slide("Changes take [s]", clock.change, 0, 60, 1, "%.1f");

  ImGui::Separator();
  changes.layout |= ImGui::InputScalar("Seed", ImGuiDataType_U64, &state.seed);
  static const common::Choices<std::uint32_t> sizes{
      {"64", 64}, {"128", 128}, {"256", 256}, {"512", 512}, {"1024", 1024}};
  changes.layout |= choose("Patch size", sea.size, sizes);
  const std::uint32_t one = 1;
  changes.layout |= ImGui::SliderScalar("Cascades", ImGuiDataType_U32, &sea.cascades, &one, &pelagic::kMaxCascades,
                                        "%u", ImGuiSliderFlags_AlwaysClamp);
  changes.layout |= slide("Span [m]", sea.span, 0, 10000, 1, "%.0f");
  changes.layout |= slide("Warp", sea.warp, 0, 0.1, 1, "%.3f");
  changes.layout |= slide("Loop [s]", sea.loopPeriod, 1, 4194304, 1, "%.0f", true);
}

void drawLight(common::Scene& scene, Changes& changes) {
  changes.sky |= slide("Sun height [deg]", scene.sky.sunElevation, -90, 90, kDegree, "%.1f");
  changes.sky |= slide("Sun toward [deg]", scene.sky.sunAzimuth, -360, 360, kDegree, "%.0f");
  changes.sky |= slide("Moon height [deg]", scene.sky.moonElevation, -90, 90, kDegree, "%.1f");
  changes.sky |= slide("Moon toward [deg]", scene.sky.moonAzimuth, -360, 360, kDegree, "%.0f");
  changes.sky |= slide("Moon's lit part", scene.sky.moonIlluminated, 0, 1);
  changes.sky |= slide("Overcast", scene.sky.overcast, 0, 1);
  changes.sky |= slide("Haze", scene.sky.haze, 0, 20);
  changes.sky |= slide("Haze height [m]", scene.sky.hazeHeight, 200, 5000, 1, "%.0f");
  changes.sky |= slide("Cloud cover", scene.sky.clouds.cover, 0, 1);
  changes.sky |= slide("Cloud base [m]", scene.sky.clouds.base, 100, 8000, 1, "%.0f");
  changes.sky |= slide("Cloud thickness [m]", scene.sky.clouds.thickness, 50, 4000, 1, "%.0f");
  changes.sky |= ImGui::InputScalar("Cloud seed", ImGuiDataType_U32, &scene.sky.clouds.seed);
  slide("Exposure [EV]", scene.exposure, -32, 32);
  slide("White balance [K]", scene.whiteBalance, 2000, 25000, 1, "%.0f");
  ImGui::Checkbox("Metering", &scene.metered);
}

void drawWater(pelagic::WaterMedium& medium, Changes& changes) {
  static const char* const absorption[] = {"Absorption red [1/m]", "Absorption green [1/m]", "Absorption blue [1/m]"};
  static const char* const backscatter[] = {"Backscatter red [1/m]", "Backscatter green [1/m]",
                                            "Backscatter blue [1/m]"};
  for (int i = 0; i < 3; ++i) {
    changes.water |= slide(absorption[i], medium.absorption[i], 1e-4, 100, "%.4f");
    changes.water |= slide(backscatter[i], medium.backscatter[i], 0, 100, "%.4f");
  }
  changes.water |= slide("Slicks", medium.slicks, 0, 0.5);
  for (const auto& [name, look] : pelagic::waterLooks()) {
    if (ImGui::RadioButton(std::string(name).c_str(), medium.look == look)) {
      medium.look = look;
      changes.water = true;
    }
  }
  changes.water |= ImGui::ColorEdit3("Deep", &medium.look.deep.x);
  changes.water |= ImGui::ColorEdit3("Shallow", &medium.look.shallow.x);
  changes.water |= slide("Shallowness", medium.look.shallowness, 0, 1, "%.2f");
  changes.water |= slide("Least opacity", medium.look.leastOpacity, 0, 1, "%.2f");
  changes.water |= slide("Opaque depth [m]", medium.look.opaqueDepth, 0.01, 1000, "%.2f");
  changes.water |= slide("Contrast", medium.look.contrast, 1, 4, "%.2f");
}

void drawReport(const pelagic::SeaReport& report, const std::vector<PassTime>& passes) {
  ImGui::Text("Hs %.2f m (grid %.2f m), Tp %.1f s (grid %.1f s)", report.targetHeight, report.gridHeight,
              report.peakPeriod, report.gridPeakPeriod);
  if (report.wavelengthsInPatch < 0.999 * pelagic::kLeastWavelengths) {
    ImGui::Text("The patches are too short for this sea: %.1f peak wavelengths of %.0f", report.wavelengthsInPatch,
                pelagic::kLeastWavelengths);
  }
  ImGui::Text("Slopes up-wind %.4f, across %.4f", report.target.upwind, report.target.crosswind);
  ImGui::Text("Whitecaps %.2f %%", 100 * report.whitecaps);
  double total = 0;
  for (const PassTime& pass : passes) {
    ImGui::Text("%8.2f ms  %s", pass.milliseconds, pass.name.c_str());
    total += pass.milliseconds;
  }
  ImGui::Text("%8.2f ms  frame", total);
}

}  // namespace

Changes drawPanel(common::Scene& scene, Clock& clock, double& fov, const pelagic::SeaReport& report,
                  const std::vector<PassTime>& passes) {
  Changes changes;
  ImGui::SetNextWindowPos({8, 8}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize({380, 520}, ImGuiCond_FirstUseEver);
  if (ImGui::Begin("Pelagic")) {
    ImGui::TextWrapped("Fly with W A S D, Q and E, faster with Shift; turn with the right mouse button.");
    if (ImGui::CollapsingHeader("Sea", ImGuiTreeNodeFlags_DefaultOpen)) drawSea(scene.sea, clock, changes);
    if (ImGui::CollapsingHeader("Light")) drawLight(scene, changes);
    if (ImGui::CollapsingHeader("Water")) drawWater(scene.medium, changes);
    if (ImGui::CollapsingHeader("Camera and time")) {
      slide("Field of view [deg]", fov, 1, 170, 1, "%.1f");
      slide("Speed of time", clock.speed, -10, 10);
      ImGui::InputDouble("Time [s]", &clock.time, 1, 60, "%.2f");
      if (!(std::abs(clock.time) <= 1e9)) clock.time = 0;
    }
    if (ImGui::CollapsingHeader("What became of it")) drawReport(report, passes);
  }
  ImGui::End();
  return changes;
}

}  // namespace sandbox
