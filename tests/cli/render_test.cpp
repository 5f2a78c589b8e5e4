/// Pictures: files, channels, the camera's geometry, statistics.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "command.hpp"
#include "image.hpp"

namespace {

const std::string kSmall = " --resolution 96x64 --size 64 --cascades 2";
constexpr double kFov = 60 * std::numbers::pi / 180;

class RenderTest : public cli::CommandTest {
 protected:
  cli::Image render(const std::string& arguments) const {
    succeed("render", "--output a.exr --aov depth,position,normal,foam,variance,body --fov 60" + kSmall + arguments);
    return cli::readImage(path("a.exr"));
  }
};

TEST_F(RenderTest, WritesPng) {
  succeed("render", kSmall);
  EXPECT_EQ(files(), std::vector<std::string>{"ocean.png"});
  const cli::Image image = cli::readImage(path("ocean.png"));
  EXPECT_EQ(image.width, 96);
  EXPECT_EQ(image.height, 64);
  EXPECT_EQ(image.types, (std::map<std::string, std::string>{{"R", "uint8"}, {"G", "uint8"}, {"B", "uint8"}}));
  EXPECT_GT(image.at("B", 48, 4), 0.1);                    // a sky
  EXPECT_GT(image.at("B", 48, 4), image.at("B", 48, 60));  // brighter than the sea below it
}

TEST_F(RenderTest, AnEnvironmentStandsInTheSky) {
  // Red toward +x and blue toward -x; the lower half, in the file's first rows, is not seen.
  std::vector<float> values;
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 16; ++column) {
      const bool ahead = column < 4 || column >= 12;
      for (const float value : {ahead ? 2.0f : 0.0f, 1.0f, ahead ? 0.0f : 2.0f}) values.push_back(row < 4 ? 50 : value);
    }
  }
  writeFile("sky.pfm", "PF\n16 8\n-1.0\n" +
                           std::string(reinterpret_cast<const char*>(values.data()), sizeof(float) * values.size()));
  const std::string look = " --environment sky.pfm --camera 0,3,0 --look-at 100,20,0";
  const cli::Image ahead = render(look + " --environment-scale 0.25");
  constexpr double kHalf = 1.0 / 1024;  // a half is off by
  EXPECT_NEAR(ahead.at("R", 48, 4), 0.5, 0.5 * kHalf);
  EXPECT_NEAR(ahead.at("G", 48, 4), 0.25, 0.25 * kHalf);
  EXPECT_EQ(ahead.at("B", 48, 4), 0);
  EXPECT_GT(ahead.at("R", 48, 62), ahead.at("B", 48, 62));  // and so in the sea
  const cli::Image turned = render(look + " --environment-turn 180");
  EXPECT_EQ(turned.at("R", 48, 4), 0);
  EXPECT_NEAR(turned.at("B", 48, 4), 2, 2 * kHalf);
}

TEST_F(RenderTest, ExposureIsInStops) {
  succeed("render", "--exposure -32 --output dark.png" + kSmall);
  const cli::Image dark = cli::readImage(path("dark.png"));
  EXPECT_LE(*std::max_element(dark["G"].begin(), dark["G"].end()), 1.0 / 255 + 1e-6);  // dithering
}

TEST_F(RenderTest, ChannelsHaveTheContractsTypes) {
  const cli::Image image = render(" --camera 0,3,0 --look-at 100,-8,0");
  EXPECT_EQ(image.types, (std::map<std::string, std::string>{{"R", "half"},
                                                             {"G", "half"},
                                                             {"B", "half"},
                                                             {"depth.Z", "float"},
                                                             {"position.X", "float"},
                                                             {"position.Y", "float"},
                                                             {"position.Z", "float"},
                                                             {"normal.X", "float"},
                                                             {"normal.Y", "float"},
                                                             {"normal.Z", "float"},
                                                             {"foam.V", "float"},
                                                             {"variance.X", "float"},
                                                             {"variance.Y", "float"},
                                                             {"body.V", "float"}}));
  int water = 0;
  for (std::size_t i = 0; i < image["depth.Z"].size(); ++i) {
    const bool surface = std::isfinite(image["depth.Z"][i]);
    EXPECT_EQ(image["body.V"][i], surface ? 1 : 0);
    EXPECT_GT(image["depth.Z"][i], 0);
    if (!surface) continue;
    ++water;
    const double away = std::hypot(image["position.X"][i], image["position.Y"][i] - 3, image["position.Z"][i]);
    EXPECT_NEAR(away / image["depth.Z"][i], 1, 1e-4);
    EXPECT_NEAR(std::hypot(image["normal.X"][i], image["normal.Y"][i], image["normal.Z"][i]), 1, 1e-2);
    EXPECT_GT(image["variance.X"][i], 0);
    EXPECT_GT(image["variance.Y"][i], 0);
    EXPECT_GE(image["foam.V"][i], 0);
    EXPECT_LE(image["foam.V"][i], 1);
  }
  EXPECT_GT(water, 96 * 64 / 3);
  EXPECT_LT(water, 96 * 64);
}

TEST_F(RenderTest, LookingDownSeesTheFieldOfViewsWidth) {
  // A sea of centimetres from 50 m: half the picture's height is 50 m tan(fov/2), the top of the picture is -z.
  const cli::Image image = render(" --wind 1 --fetch 1 --swell none --camera 10,50,20 --look-at 10,0,20");
  const double pixel = 2 * 50 * std::tan(kFov / 2) / 64;
  for (const int y : {0, 20, 63}) {
    for (const int x : {0, 30, 95}) {
      EXPECT_NEAR(image.at("position.X", x, y), 10 + (x + 0.5 - 48) * pixel, 0.1);
      EXPECT_NEAR(image.at("position.Z", x, y), 20 + (y + 0.5 - 32) * pixel, 0.1);
      EXPECT_NEAR(image.at("position.Y", x, y), 0, 0.1);
    }
  }
  EXPECT_NEAR(image.at("depth.Z", 48, 32), 50, 0.1);
}

TEST_F(RenderTest, TheCameraIsRightHanded) {
  // Looking along +x with y up, +z is to the right; lower rows are nearer.
  const cli::Image image = render(" --wind 1 --fetch 1 --swell none --camera 0,3,0 --look-at 100,3,0");
  EXPECT_LT(image.at("position.Z", 10, 60), -0.5);
  EXPECT_GT(image.at("position.Z", 85, 60), 0.5);
  EXPECT_GT(image.at("position.X", 48, 60), 1);
  EXPECT_LT(image.at("depth.Z", 48, 60), image.at("depth.Z", 48, 45));
  EXPECT_FALSE(std::isfinite(image.at("depth.Z", 48, 20)));
  // The flat sea's normal and the horizon's row: straight ahead is the middle of the picture.
  EXPECT_NEAR(image.at("normal.Y", 48, 60), 1, 0.05);
  EXPECT_EQ(image.at("body.V", 48, 30), 0);
  EXPECT_EQ(image.at("body.V", 48, 34), 1);
}

TEST_F(RenderTest, TheSunStandsWhereItWasPut) {
  // From +x turning to +z: at an azimuth of 10 degrees it is right of the middle when the camera looks along +x.
  const cli::Image image =
      render(" --camera 0,3,0 --look-at 100,3,0 --sun-azimuth 10 --sun-elevation 15 --cloud-cover 0");
  const auto brightest = std::max_element(image["G"].begin(), image["G"].begin() + 96 * 30) - image["G"].begin();
  const double focal = 32 / std::tan(kFov / 2);  // [px]
  const double degree = std::numbers::pi / 180;
  EXPECT_NEAR(static_cast<double>(brightest % 96) + 0.5, 48 + focal * std::tan(10 * degree), 1.5);
  EXPECT_NEAR(static_cast<double>(brightest / 96) + 0.5, 32 - focal * std::tan(15 * degree) / std::cos(10 * degree),
              1.5);
}

TEST_F(RenderTest, SequencesAreNumberedAndTimed) {
  succeed("render", "--frames 2 --fps 8 --first 4 --output f%04d.png --stats s.json" + kSmall);
  EXPECT_EQ(files(), (std::vector<std::string>{"f0004.png", "f0005.png", "s.json"}));
  EXPECT_EQ(readJson("s.json")["sea"]["times_s"], (std::vector<double>{0.5, 0.625}));
  EXPECT_NE(readText("f0004.png"), readText("f0005.png"));
  succeed("render", "--time 0.625 --output one.png" + kSmall);
  EXPECT_EQ(readText("f0005.png"), readText("one.png"));  // a picture does not depend on those before it
}

TEST_F(RenderTest, StatsHaveTheContractsKeys) {
  succeed("render", "--wind 5 --stats s.json --scene gale" + kSmall);
  const nlohmann::json stats = readJson("s.json");
  for (const char* key :
       {"device", "resolution", "passes", "frame_ms", "first_frame_ms", "memory_bytes", "sea", "triangles"}) {
    EXPECT_TRUE(stats.contains(key)) << key;
  }
  EXPECT_EQ(stats["resolution"], (std::vector<int>{96, 64}));
  double sum = 0;
  for (const nlohmann::json& pass : stats["passes"]) {
    EXPECT_GT(pass["ms"], 0) << pass["name"];
    sum += static_cast<double>(pass["ms"]);
  }
  EXPECT_NEAR(sum / static_cast<double>(stats["frame_ms"]), 1, 0.5);  // the sum of medians is near the sum's median
  for (const char* stage : {"waves", "sky", "surface", "composite"})
    EXPECT_GT(stats["memory_bytes"][stage], 0) << stage;
  EXPECT_GT(stats["triangles"], 100);
  EXPECT_GT(stats["first_frame_ms"], stats["frame_ms"]);
  EXPECT_EQ(stats["sea"]["wind_m_s"], 5);  // options override the scene, wherever they stand
  EXPECT_EQ(stats["sea"]["seed"], 1);
}

TEST_F(RenderTest, EverySceneRenders) {
  const cli::Outcome list = run("render", "--list-scenes");
  EXPECT_EQ(list.status, 0);
  EXPECT_TRUE(files().empty());
  for (const char* scene : {"altitude", "calm-dawn", "fresh-overcast", "gale", "moonlit", "noon-calm", "overcast-swell",
                            "storm", "sunset-glitter", "trade-wind"}) {
    EXPECT_NE(list.out.find(scene), std::string::npos) << scene;
    succeed("render", fmt::format("--scene {} --output {}.png{}", scene, scene, kSmall));
    const cli::Image image = cli::readImage(path(fmt::format("{}.png", scene)));
    double mean = 0;
    for (const double value : image["G"]) mean += value / static_cast<double>(image["G"].size());
    EXPECT_GT(mean, 0.1) << scene;  // neither a black picture nor a blank one
    EXPECT_LT(mean, 0.7) << scene;
  }
}

TEST_F(RenderTest, ScenesComeFromFiles) {
  writeFile("mine.toml",
            "title = \"Mine\"\ntime = 7\nwind = 4\nswell = [[1, 8, 90]]\nsun-elevation = 20\ncamera = [0, 4.5, 0]\n"
            "look-at = [10, 4, 0]\nfov = 50\nexposure = 2\nabsorption = [0.5, 0.1, 0.05]\n");
  succeed("render", "--scene mine.toml --stats s.json" + kSmall);
  EXPECT_EQ(readJson("s.json")["sea"]["wind_m_s"], 4);
  EXPECT_EQ(readJson("s.json")["sea"]["times_s"], std::vector<double>{7});
}

TEST_F(RenderTest, ValidationIsSilent) {
  succeed("render", "--validate --output a.exr --aov depth,position,normal,foam,variance,body" + kSmall);
  succeed("render", "--validate --output a.png" + kSmall);
}

TEST_F(RenderTest, PicturesThatDoNotFitIntoMemoryAreAnsweredByStatusFour) {
  const cli::Outcome outcome = run("render", "--resolution 16384x16384 --aov normal --output a.exr --size 64");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.err.find("does not fit"), std::string::npos) << outcome.err;
  EXPECT_TRUE(files().empty());
}

}  // namespace
