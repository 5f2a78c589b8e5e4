#include "scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <regex>

#include "environment_file.hpp"
#include "failure.hpp"
#include "settings_file.hpp"

namespace common {
namespace {

const double kDegree = glm::pi<double>() / 180;  // [rad]

Field colorField(std::string name, std::string help, const Range& range, glm::vec3& target) {
  return {std::move(name), "R,G,B", std::move(help) + ", each " + describe(range),
          [range, &target](const std::string& where, const std::vector<std::string>& texts) {
            target = glm::vec3(parseVector(where, texts.front(), range));
          }};
}

pelagic::Place parsePlace(const std::string& where, const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  const Range latitude{-90, 90, "degrees"}, longitude{-360, 360, "degrees"};
  if (parts.size() != 2) refuse(where, text, "LAT,LON: " + describe(latitude) + " and " + describe(longitude));
  return {parsePart(where, text, parts[0], "latitude", latitude) * kDegree,
          parsePart(where, text, parts[1], "longitude", longitude) * kDegree};
}

constexpr std::string_view kDates = "YYYY-MM-DDTHH:MM[:SS] in UTC, a day of the years 1800 to 2200";

pelagic::CivilTime parseDate(const std::string& where, const std::string& text) {
  static const std::regex form(R"((\d{4})-(\d\d)-(\d\d)T(\d\d):([0-5]\d)(?::([0-5]\d))?)");
  std::smatch match;
  if (!std::regex_match(text, match, form)) refuse(where, text, kDates);
  const auto number = [&](std::size_t part) { return match[part].matched ? std::stoi(match[part]) : 0; };
  const pelagic::CivilTime date{number(1), number(2), number(3), number(4) + number(5) / 60.0 + number(6) / 3600.0};
  if (!pelagic::validate(date)) refuse(where, text, kDates);
  return date;
}

/// What stands in the sky at the scene's date and place, where it has both.
void lookUpSky(Scene& scene) {
  if (!scene.date || !scene.place) return;
  const pelagic::Celestial bodies = unwrap(pelagic::celestial(*scene.date, *scene.place));
  scene.sky.sunElevation = bodies.sunElevation;
  scene.sky.sunAzimuth = bodies.sunAzimuth;
  scene.sky.moonElevation = bodies.moonElevation;
  scene.sky.moonAzimuth = bodies.moonAzimuth;
  scene.sky.moonIlluminated = bodies.moonIlluminated;
  scene.sky.starsToWorld = bodies.equatorialToWorld;
}

Fields environmentFields(pelagic::SkyEnvironment& environment) {
  return {
      {"environment", "FILE|none",
       "Picture of the sky's radiance in place of the sky, its sun, moon and clouds, also with its sun in it: "
       "longitude x "
       "latitude, twice as wide as high, at most 4096 wide, linear",
       [&environment](const std::string& where, const std::vector<std::string>& texts) {
         readEnvironment(where, texts.front(), environment);
       }},
      numberField("environment-scale", "X", "Factor on the picture's radiance", {0, 1e6, ""}, environment.scale),
      numberField("environment-turn", "DEG", "Direction of the picture's left edge, from +x turning to +z",
                  {-360, 360, "degrees"}, environment.rotation, kDegree),
  };
}

pelagic::HostLight parseLight(const std::string& where, const std::string& text) {
  constexpr double kLuxOfSun = 1.28e5;  // of the unit irradiance, over the air
  const std::vector<std::string> parts = split(text, ',');
  const bool panel = parts.size() == 12;
  if (parts.size() != 7 && !panel) {
    refuse(where, text, "X,Y,Z,RADIUS,R,G,B or X,Y,Z,WX,WY,WZ,HX,HY,HZ,R,G,B in m and cd, or none");
  }
  const auto part = [&](std::size_t i, std::string_view name, const Range& range) {
    return parsePart(where, text, parts[i], name, range);
  };
  pelagic::HostLight light;
  light.position = {part(0, "x", {-1e9, 1e9, "m"}), part(1, "y", {0, 1e5, "m"}), part(2, "z", {-1e9, 1e9, "m"})};
  if (panel) {
    for (int i = 0; i < 3; ++i) {
      light.halfWidth[i] = part(static_cast<std::size_t>(3 + i), "half the width", {-1e4, 1e4, "m"});
      light.halfHeight[i] = part(static_cast<std::size_t>(6 + i), "half the height", {-1e4, 1e4, "m"});
    }
  } else {
    light.radius = part(3, "a radius of", {1e-3, 1e4, "m"});
  }
  for (int c = 0; c < 3; ++c) {
    const double candela = part(parts.size() - 3 + static_cast<std::size_t>(c), "an intensity of", {0, 1e12, "cd"});
    light.intensity[c] = static_cast<float>(candela / kLuxOfSun);
  }
  if (panel && (light.halfWidth == glm::dvec3(0) || !pelagic::validate(std::span(&light, 1)))) {
    refuse(where, text, "half a width and half a height of 0.001 to 10000 m at right angles, no corner below 0 m");
  }
  return light;
}

Field lightField(std::vector<pelagic::HostLight>& lights) {
  return {"light", "X,Y,Z,RADIUS,R,G,B|none",
          fmt::format("A ball of light over the sea: place and radius in m, intensity in cd; or a rectangle, "
                      "X,Y,Z,WX,WY,WZ,HX,HY,HZ,R,G,B, with half its width and height as vectors, which shines toward "
                      "W x H; up to {}",
                      pelagic::kMostHostLights),
          [&lights](const std::string& where, const std::vector<std::string>& texts) {
            const bool none = texts.size() == 1 && texts.front() == "none";
            if (texts.size() > pelagic::kMostHostLights) {
              refuse(where, texts.back(), fmt::format("at most {} lights", pelagic::kMostHostLights));
            }
            lights.clear();
            for (const std::string& text : texts) {
              if (!none) lights.push_back(parseLight(where, text));
            }
          },
          true};
}

/// Before the fields of sun and moon, which override what they say.
Fields dateFields(Scene& scene) {
  return {
      {"place", "LAT,LON", "Where the date is seen, north and east positive, -90 to 90 and -360 to 360 degrees",
       [&scene](const std::string& where, const std::vector<std::string>& texts) {
         scene.place = parsePlace(where, texts.front());
         lookUpSky(scene);
       }},
      {"date", "DATE",
       fmt::format("Sun, moon and stars by date and place, +x east and +z south; their own options override it: {}",
                   kDates),
       [&scene](const std::string& where, const std::vector<std::string>& texts) {
         scene.date = parseDate(where, texts.front());
         if (!scene.place) refuse(where, texts.front(), "only with a place");
         lookUpSky(scene);
       }},
  };
}

std::string lookNames() {
  std::string list;
  for (const auto& [name, look] : pelagic::waterLooks()) list += (list.empty() ? "" : ", ") + std::string(name);
  return list;
}

pelagic::WaterLook parseLook(const std::string& where, const std::string& text) {
  for (const auto& [name, look] : pelagic::waterLooks()) {
    if (name == text) return look;
  }
  refuse(where, text, lookNames());
}

Fields sceneFields(Scene& scene) {
  const Fields own{
      {"title", "TEXT", "What the scene shows",
       [&scene](const std::string&, const std::vector<std::string>& texts) { scene.title = texts.front(); }},
      numberField("time", "S", "The moment", {-1e9, 1e9, "s"}, scene.time),
  };
  return own + seaFields(scene.sea) + lightFields(scene);
}

std::string sceneNames() {
  std::string list;
  for (const BuiltinScene& builtin : builtinScenes()) list += std::string(builtin.name) + ", ";
  return list + "or a FILE.toml that can be read";
}

}  // namespace

Fields lightFields(Scene& scene) {
  const Fields sky{
      numberField("sun-elevation", "DEG", "Height of the sun above the horizon", {-90, 90, "degrees"},
                  scene.sky.sunElevation, kDegree),
      numberField("sun-azimuth", "DEG", "Direction to the sun, from +x turning to +z", {-360, 360, "degrees"},
                  scene.sky.sunAzimuth, kDegree),
      numberField("moon-elevation", "DEG", "Height of the moon above the horizon", {-90, 90, "degrees"},
                  scene.sky.moonElevation, kDegree),
      numberField("moon-azimuth", "DEG", "Direction to the moon, from +x turning to +z", {-360, 360, "degrees"},
                  scene.sky.moonAzimuth, kDegree),
      numberField("moon-illuminated", "X", "Part of the moon's disc that is lit, 0 new, 1 full", {0, 1, ""},
                  scene.sky.moonIlluminated),
      numberField("overcast", "X", "0 clear sky, 1 overcast", {0, 1, ""}, scene.sky.overcast),
      numberField("cloud-cover", "X", "Share of the sky under clouds in a field of them, 0 none, 1 all", {0, 1, ""},
                  scene.sky.clouds.cover),
      numberField("cloud-base", "M", "Altitude of the clouds' base", {100, 8000, "m"}, scene.sky.clouds.base),
      numberField("cloud-thickness", "M", "Height of the clouds", {50, 4000, "m"}, scene.sky.clouds.thickness),
      wholeField("cloud-seed", "N", "Seed of the clouds' shape", 0, std::numeric_limits<std::uint32_t>::max(),
                 [&scene](std::uint64_t seed) { scene.sky.clouds.seed = static_cast<std::uint32_t>(seed); }),
      numberField("haze", "X", "Aerosol at sea level, 1 is clean air", {0, 20, ""}, scene.sky.haze),
      numberField("haze-height", "M", "Scale height of the aerosol, 1200 in clean air, less in a shallow layer",
                  {200, 5000, "m"}, scene.sky.hazeHeight),
      numberField("planet-radius", "KM", "Radius of the planet at sea level", {100, 1e5, "km"}, scene.planetRadius,
                  1000),
      lightField(scene.lights),
      colorField("absorption", "Absorption of the water", {1e-4, 100, "1/m"}, scene.medium.absorption),
      colorField("backscatter", "Backscattering of the water", {0, 100, "1/m"}, scene.medium.backscatter),
      numberField("slicks", "X", "How far slicks and gusts vary the slope variance of ripples, deviation over mean",
                  {0, 0.5, ""}, scene.medium.slicks),
      {"look", "NAME", "How the colour of the water is found: " + lookNames(),
       [&scene](const std::string& where, const std::vector<std::string>& texts) {
         scene.medium.look = parseLook(where, texts.front());
       }},
      numberField("exposure", "EV", "Radiance is multiplied by 2^EV before the tone curve", {-32, 32, "EV"},
                  scene.exposure),
      numberField("white-balance", "K", "Light of this colour temperature becomes grey", {2000, 25000, "K"},
                  scene.whiteBalance),
      {"metering", "off|on", "Whether the picture exposes itself to middle grey, and exposure is added: off, on",
       [&scene](const std::string& where, const std::vector<std::string>& texts) {
         if (texts.front() != "on" && texts.front() != "off") refuse(where, texts.front(), "off or on");
         scene.metered = texts.front() == "on";
       }},
  };
  return dateFields(scene) + environmentFields(scene.environment) + sky + viewFields(scene.view);
}

void loadScene(const std::string& option, const std::string& name, Scene& scene) {
  scene = Scene{};
  for (const BuiltinScene& builtin : builtinScenes()) {
    if (builtin.name == name) return applySettings(name, builtin.text, sceneFields(scene));
  }
  const bool file = name.size() > 5 && name.compare(name.size() - 5, 5, ".toml") == 0;
  if (!file) refuse(option, name, sceneNames());
  applySettings(name, readTextFile(option, name), sceneFields(scene));
}

std::string listScenes() {
  std::string list;
  for (const BuiltinScene& builtin : builtinScenes()) {
    Scene scene;
    loadScene("--scene", std::string(builtin.name), scene);
    list += fmt::format("{:<16}{}\n", builtin.name, scene.title);
  }
  return list;
}

void addSceneOptions(Program& program, Scene& scene) {
  loadScene("--scene", std::string(kDefaultScene), scene);
  program.add(
      {{"scene", "NAME|FILE.toml", fmt::format("Scene that the other options change; default {}", kDefaultScene),
        [&scene](const std::string& where, const std::vector<std::string>& texts) {
          loadScene(where, texts.front(), scene);
        }}},
      "Scene");
  const Fields sea = seaFields(scene.sea);
  program.addFile("--sea", "Options of the sea from a file; its keys are their names, options override it", sea, "Sea");
  program.add(sea, "Sea");
  program.add(lightFields(scene), "Light, water and camera");
  program.app().final_callback([&program, &scene] {
    const CLI::Option& place = *program.app().get_option("--place");
    if (place.count() > 0 && !scene.date) refuse("--place", place.as<std::string>(), "only with a date");
  });
  program.app().footer(
      "Scene and sea files are TOML; their keys are the options' names: wind = 8, camera = [0, 3, 0],\n"
      "swell = [[1.1, 10, 95, 40]]. A scene also has title and time. --sea takes the keys of the group Sea.");
}

pelagic::SkyState skyState(const Scene& scene) {
  pelagic::SkyState sky = scene.sky;
  const double wind = scene.sea.state.windSpeed, direction = scene.sea.state.windDirection;
  sky.clouds.velocity = wind * glm::dvec2(std::cos(direction), std::sin(direction));
  return sky;
}

pelagic::OceanInfo oceanInfo(const Scene& scene) {
  pelagic::OceanInfo info;
  info.waves = wavesInfo(scene.sea, pelagic::MapPrecision::half);
  info.sky = skyState(scene);
  info.environment = scene.environment;
  info.medium = scene.medium;
  info.lights = scene.lights;
  info.surface.planetRadius = scene.planetRadius;
  return info;
}

}  // namespace common
