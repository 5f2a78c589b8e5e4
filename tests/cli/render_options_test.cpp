/// Bad input of pelagic-render: status 2 and one line.
#include <fmt/format.h>

#include <limits>

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
      {"--white-balance", {"1999", "25001", "nan", "''"}, "2000 to 25000 K"},
      {"--exposure", {"33", "-33", "nan", "''"}, "-32 to 32 EV"},
      {"--date",
       {"noon", "2024-06-21", "2024-02-31T12:00", "2024-06-21T24:00", "2024-06-21T12:60", "2024-06-21T12:00Z",
        "1799-12-31T12:00", "''"},
       "YYYY-MM-DDTHH:MM[:SS] in UTC, a day of the years 1800 to 2200"},
      {"--place", {"90.1,0", "nan,0"}, "latitude -90 to 90 degrees"},
      {"--place", {"0,361"}, "longitude -360 to 360 degrees"},
      {"--place", {"50", "50,4,3", "''"}, "LAT,LON"},
      {"--environment", {"missing.exr", "''"}, "an image in FILE"},
      {"--environment-scale", {"-1", "nan", "1000001"}, "0 to 1000000"},
      {"--environment-turn", {"361", "inf", "''"}, "-360 to 360 degrees"},
      {"--overcast", {"-0.1", "1.1", "nan", "''"}, "0 to 1"},
      {"--haze", {"-1", "21", "inf", "''"}, "0 to 20"},
      {"--haze-height", {"0", "199", "5001", "nan", "''"}, "200 to 5000 m"},
      {"--light", {"1,2,3,4,5,6", "1,2,3,4,5,6,7,8", "''"}, "X,Y,Z,RADIUS,R,G,B"},
      {"--light", {"1,-1,3,1,1,1,1", "1,nan,3,1,1,1,1"}, "y 0 to 100000 m"},
      {"--light", {"1,1,3,0,1,1,1"}, "a radius of 0.001 to 10000 m"},
      {"--light", {"1,1,3,1,1,-1,1", "1,1,3,1,1,1,inf"}, "an intensity of 0 to 1000000000000 cd"},
      {"--light", {"1,2,3,4,5,6,7,8,9,10,11", "1,2,3,4,5,6,7,8,9,10,11,12,13"}, "X,Y,Z,WX,WY,WZ,HX,HY,HZ,R,G,B"},
      {"--light", {"0,9,0,nan,0,0,0,2,0,1,1,1", "0,9,0,1,20000,0,0,2,0,1,1,1"}, "half the width -10000 to 10000 m"},
      {"--light",
       {"0,9,0,0,0,0,0,2,0,1,1,1", "0,9,0,1,0,0,0,0,0,1,1,1", "0,9,0,0,0,0,0,0,0,1,1,1", "0,9,0,1,1,0,0,2,0,1,1,1",
        "0,9,0,1,0,0,0,9.5,0,1,1,1"},
       "half a width and half a height of 0.001 to 10000 m at right angles, no corner below 0 m"},
      {"--planet-radius", {"99", "100001", "-6371", "nan", "''"}, "100 to 100000 km"},
      {"--slicks", {"-0.1", "0.6", "nan"}, "0 to 0.5"},
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

TEST_F(RenderOptionsTest, EnvironmentsThatAreNoSky) {
  const auto write = [&](const std::string& name, int width, int height, float bad) {
    std::vector<float> values(static_cast<std::size_t>(width * height) * 3, 1.0f);
    values.back() = bad;  // rows from the bottom: the last pixel of the zenith's
    writeFile(name, fmt::format("PF\n{} {}\n-1.0\n", width, height) +
                        std::string(reinterpret_cast<const char*>(values.data()), 4 * values.size()));
  };
  write("square.pfm", 8, 8, 1);
  refused("render", "--environment square.pfm", {"--environment", "'square.pfm'", "height is 8", "half of width, 4"});
  write("nan.pfm", 8, 4, std::numeric_limits<float>::quiet_NaN());
  refused("render", "--environment nan.pfm", {"--environment", "'nan.pfm'", "radiance[7] is (1, 1, nan)", "0 … 1e9"});
  write("negative.pfm", 8, 4, -2);
  refused("render", "--environment negative.pfm", {"'negative.pfm'", "radiance[7] is (1, 1, -2)", "0 … 1e9"});
  write("wide.pfm", 4100, 2050, 1);
  refused("render", "--environment wide.pfm", {"'wide.pfm'", "width is 4100", "4 … 4096"});
  writeFile("huge.pfm", "PF\n100000 50000\n-1.0\n");
  refused("render", "--environment huge.pfm", {"'huge.pfm'", "at most 33554432 pixels, not 100000 x 50000"});
  writeFile("scene.toml", "environment = \"nan.pfm\"\n");
  refused("render", "--scene scene.toml", {"scene.toml:1: environment", "'nan.pfm'", "0 … 1e9"});
}

TEST_F(RenderOptionsTest, ContradictionsAreRefused) {
  refused("render", "--time 3 --frames 2 --fps 10 --output a%04d.png", {"--time", "'3'", "--frames"});
  std::string lights;
  for (int i = 0; i < 17; ++i) lights += " --light 1,1,1,1,1,1,1";
  refused("render", lights, {"--light", "at most 16 lights"});
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
