#include "sea_options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

#include "failure.hpp"
#include "image_file.hpp"
#include "spectrum_file.hpp"

namespace common {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kDegree = glm::pi<double>() / 180;  // [rad]

pelagic::Swell parseSwell(const std::string& where, const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() < 3 || parts.size() > 4) refuse(where, text, "HS_M,TP_S,DEG or HS_M,TP_S,DEG,SPREAD");
  pelagic::Swell swell;
  swell.significantHeight = parsePart(where, text, parts[0], "a height of", {0, 20, "m", true});
  swell.peakPeriod = parsePart(where, text, parts[1], "a period of", {1, 30, "s"});
  swell.direction = parsePart(where, text, parts[2], "a direction of", {-360, 360, "degrees"}) * kDegree;
  if (parts.size() == 4) swell.spread = parsePart(where, text, parts[3], "a spread of", {1, 200, ""});
  return swell;
}

pelagic::Trochoid parseTrochoid(const std::string& where, const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() < 3 || parts.size() > 5) refuse(where, text, "AMPLITUDE_M,LENGTH_M,DEG[,STEEPNESS[,PHASE_DEG]]");
  pelagic::Trochoid wave;
  wave.amplitude = parsePart(where, text, parts[0], "an amplitude of", {0, 20, "m", true});
  wave.wavelength = parsePart(where, text, parts[1], "a wavelength of", {0, 1e5, "m", true});
  wave.direction = parsePart(where, text, parts[2], "a direction of", {-360, 360, "degrees"}) * kDegree;
  if (parts.size() > 3) wave.steepness = parsePart(where, text, parts[3], "a steepness of", {0, 100, ""});
  if (parts.size() > 4) wave.phase = parsePart(where, text, parts[4], "a phase of", {-360, 360, "degrees"}) * kDegree;
  return wave;
}

std::vector<pelagic::Trochoid> parseTrochoids(const std::string& where, const std::vector<std::string>& texts) {
  std::vector<pelagic::Trochoid> waves;
  if (texts.size() == 1 && texts.front() == "none") return waves;
  for (const std::string& text : texts) waves.push_back(parseTrochoid(where, text));
  return waves;
}

pelagic::TrochoidPick parsePick(const std::string& where, const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() > 3) refuse(where, text, "COUNT[,ROUGHNESS[,STEEPNESS]]");
  pelagic::TrochoidPick pick;
  pick.count = static_cast<std::uint32_t>(parseWhole(where, parts[0], 0, 256));
  if (parts.size() > 1) pick.roughness = parsePart(where, text, parts[1], "a roughness of", {0, 1, ""});
  if (parts.size() > 2) pick.steepness = parsePart(where, text, parts[2], "a steepness of", {0, 1, ""});
  return pick;
}

std::array<double, pelagic::kOctaves> parseGains(const std::string& where, const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  const std::string name = fmt::format("{} numbers with commas, each", pelagic::kOctaves);
  if (parts.size() != pelagic::kOctaves) refuse(where, text, name + " 0 to 10");
  std::array<double, pelagic::kOctaves> gains{};
  for (std::size_t i = 0; i < gains.size(); ++i) gains[i] = parsePart(where, text, parts[i], name, {0, 10, ""});
  return gains;
}

std::vector<pelagic::Swell> parseSwells(const std::string& where, const std::vector<std::string>& texts) {
  std::vector<pelagic::Swell> trains;
  if (texts.size() == 1 && texts.front() == "none") return trains;
  for (const std::string& text : texts) trains.push_back(parseSwell(where, text));
  return trains;
}

pelagic::GainMap parseGainMap(const std::string& where, const std::string& text) {
  if (text == "none") return {};
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 4) refuse(where, text, "FILE,X_M,Z_M,SPACING_M");
  FloatImage image = readImage(where, text, parts[0]);
  pelagic::GainMap map;
  map.origin.x = parsePart(where, text, parts[1], "an x of", {-1e9, 1e9, "m"});
  map.origin.y = parsePart(where, text, parts[2], "a z of", {-1e9, 1e9, "m"});
  map.spacing = parsePart(where, text, parts[3], "a spacing of", {0.1, 1e6, "m"});
  map.width = image.width;
  map.height = image.height;
  map.bands = image.channels;
  map.gains = std::move(image.values);
  return map;
}

void setSpectrum(const std::string& where, const std::string& text, pelagic::SeaState& state) {
  if (text.size() > 4 && text.compare(text.size() - 4, 4, ".csv") == 0) {
    state.table = readSpectrum(where, text);
    state.spectrum = pelagic::Spectrum::table;
    return;
  }
  state.spectrum = parseChoice(where, text, spectra(), ", or a measured one: FILE.csv");
}

}  // namespace

const Choices<pelagic::Spectrum>& spectra() {
  static const Choices<pelagic::Spectrum> choices{{"phillips", pelagic::Spectrum::phillips},
                                                  {"pierson-moskowitz", pelagic::Spectrum::piersonMoskowitz},
                                                  {"jonswap", pelagic::Spectrum::jonswap},
                                                  {"tma", pelagic::Spectrum::tma},
                                                  {"elfouhaily", pelagic::Spectrum::elfouhaily}};
  return choices;
}

const Choices<pelagic::Spreading>& spreadings() {
  static const Choices<pelagic::Spreading> choices{{"cos2", pelagic::Spreading::cos2},
                                                   {"mitsuyasu", pelagic::Spreading::mitsuyasu},
                                                   {"hasselmann", pelagic::Spreading::hasselmann},
                                                   {"donelan-banner", pelagic::Spreading::donelanBanner},
                                                   {"elfouhaily", pelagic::Spreading::elfouhaily}};
  return choices;
}

Fields seaFields(SeaSettings& sea) {
  using Texts = std::vector<std::string>;
  pelagic::SeaState& state = sea.state;
  return {
      numberField("wind", "M_PER_S", "Wind speed at 10 m height", {0.1, 60, "m/s"}, state.windSpeed),
      numberField("wind-direction", "DEG", "Direction the wind blows toward, from +x turning to +z",
                  {-360, 360, "degrees"}, state.windDirection, kDegree),
      numberField("fetch", "KM", "Distance over which the wind blows", {0.1, 10000, "km"}, state.fetch, 1000),
      numberField("depth", "M", "Water depth", {0.5, kInfinity, "m"}, state.depth),
      {"spectrum", "NAME|FILE.csv",
       "Spectrum of the wind sea: " + names(spectra()) + ", or a measured one (see examples/README.md)",
       [&state](const std::string& where, const Texts& t) { setSpectrum(where, t.front(), state); }},
      {"spreading", "NAME", "Distribution over directions: " + names(spreadings()),
       [&state](const std::string& where, const Texts& t) {
         state.spreading = parseChoice(where, t.front(), spreadings());
       }},
      numberField("swell-sharpening", "X", "How far the wind sea is narrowed toward swell", {0, 1, ""},
                  state.swellSharpening),
      {"octave-gain", "G,G,...",
       fmt::format("For artists: {} factors on the amplitude of waves about 512, 256, ... 0.25 m long, each 0 to 10",
                   pelagic::kOctaves),
       [&state](const std::string& where, const Texts& t) { state.octaveGain = parseGains(where, t.front()); }},
      {"swell", "HS_M,TP_S,DEG[,SPREAD]",
       "A train of swell, repeatable: height more than 0 to 20 m, period 1 to 30 s, direction -360 to 360 degrees, "
       "spread 1 to 200 (larger is narrower); 'none' for no swell",
       [&state](const std::string& where, const Texts& t) { state.swell = parseSwells(where, t); }, true},
      {"trochoid", "AMPLITUDE_M,LENGTH_M,DEG[,STEEPNESS[,PHASE_DEG]]",
       "A single Gerstner wave, repeatable: amplitude more than 0 to 20 m, wavelength within the patches', direction "
       "and "
       "phase -360 to 360 degrees, steepness 0 to 100 (1: circles); 'none' for no such wave",
       [&state](const std::string& where, const Texts& t) { state.trochoids = parseTrochoids(where, t); }, true},
      {"pick-trochoids", "COUNT[,ROUGHNESS[,STEEPNESS]]",
       "Draw the long waves by 0 to 256 trochoids; share 0 to 1 of them that stays random, and 0 (round) to 1 (sharp)",
       [&state](const std::string& where, const Texts& t) { state.trochoidPick = parsePick(where, t.front()); }},
      {"gain-map", "FILE,X_M,Z_M,SPACING_M",
       "Image of gains, 0 to 4, on the waves' amplitude over the world: row = z, column = x, one channel or one a "
       "cascade; where its first pixel lies and how far apart they are; 'none' for no map",
       [&sea](const std::string& where, const Texts& t) { sea.gain = parseGainMap(where, t.front()); }},
      numberField("choppiness", "X", "Horizontal displacement, 1 is physical", {0, 2, ""}, state.choppiness),
      numberField("asymmetry", "X", "How far wind waves lean forward, 0 not at all, 1 as measured slopes are skewed",
                  {0, 2, ""}, state.asymmetry),
      wholeField("seed", "N", "Seed of the random numbers", 0, std::numeric_limits<std::uint64_t>::max(),
                 [&state](std::uint64_t seed) { state.seed = seed; }),
      numberField("loop", "SECONDS", "Period after which the sea repeats exactly", {1, 4194304, "s"}, sea.loopPeriod),
      wholeField("cascades", "N", "Number of FFT patches", 1, pelagic::kMaxCascades,
                 [&sea](std::uint64_t count) { sea.cascades = static_cast<std::uint32_t>(count); }),
      numberField("span", "M", "Least length of the longest patch, after which the sea repeats without --warp",
                  {0, 1e5, "m"}, sea.span),
      numberField("warp", "X", "How far waves differ from those a patch away, 0 not at all", {0, 0.1, ""}, sea.warp),
      {"size", "N", "Samples along each side of a patch: 64, 128, 256, 512, 1024",
       [&sea](const std::string& where, const Texts& t) {
         static const Choices<std::uint32_t> sizes{
             {"64", 64}, {"128", 128}, {"256", 256}, {"512", 512}, {"1024", 1024}};
         sea.size = parseChoice(where, t.front(), sizes);
       }},
  };
}

pelagic::WavesInfo wavesInfo(const SeaSettings& sea, pelagic::MapPrecision precision) {
  pelagic::WavesInfo info;
  info.sea = sea.state;
  info.layout = unwrap(pelagic::waveLayout(sea.state, sea.cascades, sea.size, sea.span));
  info.loopPeriod = sea.loopPeriod;
  info.precision = precision;
  info.warp = sea.warp;
  info.gain = sea.gain;
  return info;
}

}  // namespace common
