/// Bad input of pelagic-render: status 2 and one line.
#include "bad_values.hpp"
#include "command.hpp"

namespace {

class RenderOptionsTest : public cli::CommandTest {};

const std::vector<cli::Bad>& badPicture() {
  static const std::vector<cli::Bad> list{
      {"--scene", {"moon", "missing.toml", "''"}, ""},
      {"--resolution", {"640", "0x360", "640x0", "-640x360", "16385x1", "640x360x3", "1.5x2", "''"}, "1 to 16384"},
      {"--first", {"-1", "1.5", "100000001", "''"}, "whole numbers from 0 to 100000000"},
      {"--camera", {"0,3", "nan,3,0", "2e9,3,0", "0,3,inf", "''"}, "-1000000000 to 1000000000 m"},
      {"--camera", {"0,-10001,0", "0,100001,0"}, "-10000 to 100000 m"},
      {"--look-at", {"0", "0,0,1e300", "''"}, "-1000000000 to 1000000000 m"},
      {"--fov", {"0", "-45", "171", "nan", "''"}, "0.1 to 170 degrees"},
      {"--sun-elevation", {"91", "-91", "nan", "''"}, "-90 to 90 degrees"},
      {"--sun-azimuth", {"361", "inf", "''"}, "-360 to 360 degrees"},
      {"--exposure", {"33", "-33", "nan", "''"}, "-32 to 32 EV"},
      {"--date",
       {"noon", "2024-06-21", "2024-02-31T12:00", "2024-06-21T24:00", "2024-06-21T12:60", "2024-06-21T12:00Z",
        "1799-12-31T12:00", "''"},
       "YYYY-MM-DDTHH:MM[:SS] in UTC, a day of the years 1800 to 2200"},
      {"--place", {"90.1,0", "nan,0"}, "latitude -90 to 90 degrees"},
      {"--place", {"0,361"}, "longitude -360 to 360 degrees"},
      {"--place", {"50", "50,4,3", "''"}, "LAT,LON"},
      {"--overcast", {"-0.1", "1.1", "nan", "''"}, "0 to 1"},
      {"--haze", {"-1", "21", "inf", "''"}, "0 to 20"},
      {"--planet-radius", {"99", "100001", "-6371", "nan", "''"}, "100 to 100000 km"},
      {"--absorption", {"0,0,0", "1,1", "1,1,101", "''"}, "0.0001 to 100 1/m"},
      {"--backscatter", {"-1,0,0", "nan,0,0", "''"}, "0 to 100 1/m"},
      {"--look", {"blue", "Natural", "''"}, "natural, turquoise, glassy, painted"},
      {"--aov", {"colour", "depth,", "depth,depth", "''"}, ""},
      {"--output",
       {"ocean", "ocean.jpg", ".png", "missing/ocean.png", "/proc/ocean.png", "ocean%.png", "ocean%5d.png",
        "ocean%04d%04d.png", "''"},
       ""},
      {"--stats", {"missing/stats.json", "/", "''"}, ""},
  };
  return list;
}

TEST_F(RenderOptionsTest, PictureOutOfRange) {
  for (const cli::Bad& bad : badPicture()) {
    for (const char* value : bad.values) refused("render", std::string(bad.option) + " " + value, answer(bad, value));
  }
}

TEST_F(RenderOptionsTest, ContradictionsAreRefused) {
  refused("render", "--time 3 --frames 2 --fps 10 --output a%04d.png", {"--time", "'3'", "--frames"});
  refused("render", "--first 3", {"--first", "'3'", "--frames"});
  refused("render", "--frames 2 --fps 10 --output a.png", {"--output", "'a.png'", "%04d"});
  refused("render", "--output a.png --stats a.png", {"--stats", "'a.png'", "--output"});
  refused("render", "--aov depth --output a.png", {"--aov", "'depth'", ".exr"});
  refused("render", "--camera 1,2,3 --look-at 1,2,3", {"--look-at", "--camera"});
  refused("render", "--date 2024-06-21T12:00", {"--date", "'2024-06-21T12:00'", "only with a place"});
  refused("render", "--place 50,-4", {"--place", "'50,-4'", "only with a date"});
  refused("render", "--wind 99", {"--wind", "'99'", "0.1 to 60 m/s"});
  refused("render", "--device 99", {"--device", "'99'", "allowed: 0 '"});
}

TEST_F(RenderOptionsTest, SceneFilesAreAnsweredWithTheirLine) {
  writeFile("a.toml", "wind = 8\nexposur = 2\n");
  refused("render", "--scene a.toml", {"a.toml:2", "exposur", "allowed: ", "exposure"});
  writeFile("a.toml", "camera = [0, 3, 0]\n\nfov = 500\n");
  refused("render", "--scene a.toml", {"a.toml:3", "fov", "'500'", "0.1 to 170 degrees"});
  writeFile("a.toml", "date = \"2024-06-21T12:00\"\n");
  refused("render", "--scene a.toml --place 50,-4", {"a.toml:1", "date", "only with a place"});
  writeFile("a.toml", "place = [50, -4]\ndate = 2024-06-21T12:00:00\n");
  refused("render", "--scene a.toml", {"a.toml:2", "date", "wrong type", "YYYY-MM-DDTHH:MM[:SS]"});
  writeFile("a.toml", "exposure = 2\n");
  refused("render", "--sea a.toml", {"a.toml:1", "exposure"});
}

}  // namespace
