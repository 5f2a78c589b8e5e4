/// The sun by date and place, from options and scene files, and what overrides it.
#include <fmt/format.h>

#include <numbers>
#include <pelagic/ephemeris.hpp>

#include "command.hpp"
#include "image.hpp"

namespace {

constexpr double kDegree = std::numbers::pi / 180;
/// A morning and an afternoon off Land's End.
const pelagic::Place kPlace{50 * kDegree, -6 * kDegree};
const pelagic::CivilTime kMorning{2024, 6, 21, 7.5}, kAfternoon{2024, 6, 21, 15 + 20 / 60.0 + 30 / 3600.0};

class DateTest : public cli::CommandTest {
 protected:
  /// The picture of a camera that looks south.
  cli::Image render(const std::string& arguments) const {
    succeed("render",
            "--resolution 48x32 --size 64 --cascades 1 --fov 120 --camera 0,9,0 --look-at 0,9,9 --output a.exr " +
                arguments);
    return cli::readImage(path("a.exr"));
  }
  /// Are they pictures of one sky?
  static bool same(const cli::Image& a, const cli::Image& b) {
    for (const char* channel : {"R", "G", "B"}) {
      for (std::size_t i = 0; i < a[channel].size(); ++i) {
        if (std::abs(a[channel][i] - b[channel][i]) > 0.01 * std::abs(b[channel][i]) + 1e-6) return false;
      }
    }
    return true;
  }
  static std::string elevation(double radians) { return fmt::format(" --sun-elevation {}", radians / kDegree); }
  static std::string azimuth(double radians) { return fmt::format(" --sun-azimuth {}", radians / kDegree); }
};

TEST_F(DateTest, SetsTheSun) {
  const pelagic::Celestial morning = *celestial(kMorning, kPlace), afternoon = *celestial(kAfternoon, kPlace);
  const cli::Image expected = render(elevation(morning.sunElevation) + azimuth(morning.sunAzimuth));
  EXPECT_TRUE(same(render("--date 2024-06-21T07:30 --place 50,-6"), expected));
  const cli::Image later = render("--place 50,-6 --date 2024-06-21T15:20:30");
  EXPECT_TRUE(same(later, render(elevation(afternoon.sunElevation) + azimuth(afternoon.sunAzimuth))));
  EXPECT_FALSE(same(later, expected));
}

TEST_F(DateTest, AnglesOfTheSunOverrideIt) {
  const pelagic::Celestial morning = *celestial(kMorning, kPlace);
  const cli::Image low = render(elevation(0.1) + azimuth(morning.sunAzimuth));
  EXPECT_TRUE(same(render("--date 2024-06-21T07:30 --place 50,-6" + elevation(0.1)), low));
  EXPECT_TRUE(same(render(elevation(0.1) + " --date 2024-06-21T07:30 --place 50,-6"), low)) << "in any order";
  writeFile("a.toml",
            fmt::format("sun-elevation = {}\ndate = \"2024-06-21T07:30\"\nplace = [50, -6]\n", 0.1 / kDegree));
  EXPECT_TRUE(same(render("--scene a.toml"), render("--scene a.toml" + elevation(0.1) + azimuth(morning.sunAzimuth))));
}

TEST_F(DateTest, OptionsOverrideTheScenesFile) {
  const pelagic::Celestial afternoon = *celestial(kAfternoon, kPlace);
  const std::string sun = elevation(afternoon.sunElevation) + azimuth(afternoon.sunAzimuth);
  writeFile("angles.toml", "sun-elevation = 5\nsun-azimuth = 90\nplace = [50, -6]\n");
  const cli::Image expected = render("--scene angles.toml" + sun);
  EXPECT_TRUE(same(render("--scene angles.toml --date 2024-06-21T15:20:30"), expected));
  writeFile("date.toml", "date = \"2024-06-21T15:20:30\"\nplace = [-10, 80]\n");
  EXPECT_TRUE(same(render("--scene date.toml --place 50,-6"), expected));
}

}  // namespace
