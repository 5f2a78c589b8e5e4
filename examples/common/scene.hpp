/// A scene: sea, sky, water and camera of one picture.
#pragma once

#include <optional>
#include <pelagic/ephemeris.hpp>
#include <pelagic/ocean.hpp>
#include <span>

#include "program.hpp"
#include "sea_options.hpp"
#include "view.hpp"

namespace common {

struct Scene {
  std::string title;
  double time = 0;  ///< [s]
  SeaSettings sea;
  pelagic::SkyState sky;
  pelagic::SkyEnvironment environment;     ///< In place of the sky, where it has a width.
  std::optional<pelagic::Place> place;     ///< Where the scene lies; then +x is east and +z south.
  std::optional<pelagic::CivilTime> date;  ///< When.
  pelagic::WaterMedium medium;
  std::vector<pelagic::HostLight> lights;
  double planetRadius = pelagic::kEarthRadius;  ///< [m]
  View view;
  double exposure = 0;         ///< [EV]
  double whiteBalance = 6504;  ///< [K]
  bool metered = false;        ///< The picture exposes itself, `exposure` is added.
};

/// A scene that is built into the programs, as TOML.
struct BuiltinScene {
  std::string_view name;
  std::string_view text;
};
std::span<const BuiltinScene> builtinScenes();
inline constexpr std::string_view kDefaultScene = "trade-wind";

/// Setters of everything but the sea; `scene` must outlive them.
Fields lightFields(Scene& scene);
/// Replaces the whole scene by a built-in one or by the file `name`.
/// Throws a Failure that names `option` or the file's line.
void loadScene(const std::string& option, const std::string& name, Scene& scene);
/// Names and titles, one line each.
std::string listScenes();

/// Loads the default scene and adds --scene and every option that changes a scene. `scene` must outlive the program.
void addSceneOptions(Program& program, Scene& scene);

/// The scene's sky, whose clouds drift with its wind.
pelagic::SkyState skyState(const Scene& scene);
pelagic::OceanInfo oceanInfo(const Scene& scene);

}  // namespace common
