#include <cmath>
#include <gpu/context.hpp>
#include <sstream>
#include <waves/spectrum_table.hpp>

#include <pelagic/sea_state.hpp>

namespace pelagic {
namespace {

struct Field {
  const char* name;
  double value, low, high;
  const char* unit;
};

Result<void> check(const std::string& owner, const Field& field) {
  if (field.value >= field.low && field.value <= field.high) return {};
  std::ostringstream text;
  text << owner << "::" << field.name << " is " << field.value << ", it must lie in " << field.low << " … "
       << field.high;
  if (*field.unit) text << ' ' << field.unit;
  return gpu::reject(text.str());
}

}  // namespace

Result<void> validate(const SeaState& sea) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kAnyAngle = 1e6;  // finite, and small enough to keep its fraction of a turn
  const Field fields[] = {
      {"windSpeed", sea.windSpeed, 0.1, 60, "m/s"},
      {"windDirection", sea.windDirection, -kAnyAngle, kAnyAngle, "rad"},
      {"fetch", sea.fetch, 100, 1e7, "m"},
      {"depth", sea.depth, 0.5, kInfinity, "m"},
      {"choppiness", sea.choppiness, 0, 2, ""},
      {"asymmetry", sea.asymmetry, 0, 2, ""},
      {"swellSharpening", sea.swellSharpening, 0, 1, ""},
  };
  for (const Field& field : fields) PELAGIC_CHECK(check("SeaState", field));
  for (std::size_t i = 0; i < kOctaves; ++i) {
    const std::string name = "octaveGain[" + std::to_string(i) + "]";
    PELAGIC_CHECK(check("SeaState", {name.c_str(), sea.octaveGain[i], 0, 10, ""}));
  }
  if (sea.spectrum < Spectrum::phillips || sea.spectrum > Spectrum::table) {
    return gpu::reject("SeaState::spectrum is " + std::to_string(static_cast<int>(sea.spectrum)) +
                       ", it must be one of the enumerators");
  }
  if (sea.spreading < Spreading::cos2 || sea.spreading > Spreading::elfouhaily) {
    return gpu::reject("SeaState::spreading is " + std::to_string(static_cast<int>(sea.spreading)) +
                       ", it must be one of the enumerators");
  }
  if (sea.spectrum == Spectrum::table) PELAGIC_CHECK(validate(sea.table));
  for (std::size_t i = 0; i < sea.swell.size(); ++i) {
    const Swell& swell = sea.swell[i];
    const Field trains[] = {
        {"significantHeight", swell.significantHeight, 1e-3, 20, "m"},
        {"peakPeriod", swell.peakPeriod, 1, 30, "s"},
        {"direction", swell.direction, -kAnyAngle, kAnyAngle, "rad"},
        {"spread", swell.spread, 1, 200, ""},
    };
    for (const Field& field : trains) PELAGIC_CHECK(check("SeaState::swell[" + std::to_string(i) + "]", field));
  }
  if (sea.trochoids.size() > 256) {
    return gpu::reject("SeaState::trochoids has " + std::to_string(sea.trochoids.size()) +
                       " waves, it must have 256 at most");
  }
  for (std::size_t i = 0; i < sea.trochoids.size(); ++i) {
    const Trochoid& wave = sea.trochoids[i];
    const Field waves[] = {{"amplitude", wave.amplitude, 1e-6, 20, "m"},
                           {"wavelength", wave.wavelength, 1e-4, 1e5, "m"},
                           {"direction", wave.direction, -kAnyAngle, kAnyAngle, "rad"},
                           {"steepness", wave.steepness, 0, 100, ""},
                           {"phase", wave.phase, -kAnyAngle, kAnyAngle, "rad"}};
    for (const Field& field : waves) PELAGIC_CHECK(check("SeaState::trochoids[" + std::to_string(i) + "]", field));
  }
  if (sea.trochoidPick.count > 256) {
    return gpu::reject("TrochoidPick::count is " + std::to_string(sea.trochoidPick.count) + ", it must lie in 0 … 256");
  }
  PELAGIC_CHECK(check("TrochoidPick", {"roughness", sea.trochoidPick.roughness, 0, 1, ""}));
  PELAGIC_CHECK(check("TrochoidPick", {"steepness", sea.trochoidPick.steepness, 0, 1, ""}));
  return {};
}

}  // namespace pelagic
