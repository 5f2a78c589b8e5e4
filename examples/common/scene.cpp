#include "scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

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
      numberField("cloud-cover", "X", "Share of the sky under clouds, 0 none, 1 all", {0, 1, ""},
                  scene.sky.clouds.cover),
      numberField("cloud-base", "M", "Altitude of the clouds' base", {100, 8000, "m"}, scene.sky.clouds.base),
      numberField("cloud-thickness", "M", "Height of the clouds", {50, 4000, "m"}, scene.sky.clouds.thickness),
      wholeField("cloud-seed", "N", "Seed of the clouds' shape", 0, std::numeric_limits<std::uint32_t>::max(),
                 [&scene](std::uint64_t seed) { scene.sky.clouds.seed = static_cast<std::uint32_t>(seed); }),
      numberField("haze", "X", "Aerosol, 1 is clean air over the sea", {0, 20, ""}, scene.sky.haze),
      colorField("absorption", "Absorption of the water", {1e-4, 100, "1/m"}, scene.medium.absorption),
      colorField("backscatter", "Backscattering of the water", {0, 100, "1/m"}, scene.medium.backscatter),
      numberField("exposure", "EV", "Radiance is multiplied by 2^EV before the tone curve", {-32, 32, "EV"},
                  scene.exposure),
  };
  return sky + viewFields(scene.view);
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
  program.app().footer(
      "Scene and sea files are TOML; their keys are the options' names: wind = 8, camera = [0, 3, 0],\n"
      "swell = [[1.1, 10, 95, 40]]. A scene also has title and time. --sea takes the keys of the group Sea.");
}

pelagic::OceanInfo oceanInfo(const Scene& scene) {
  pelagic::OceanInfo info;
  info.waves = wavesInfo(scene.sea, pelagic::MapPrecision::half);
  info.sky = scene.sky;
  // Clouds drift with the wind.
  const double wind = scene.sea.state.windSpeed, direction = scene.sea.state.windDirection;
  info.sky.clouds.velocity = wind * glm::dvec2(std::cos(direction), std::sin(direction));
  info.medium = scene.medium;
  return info;
}

}  // namespace common
