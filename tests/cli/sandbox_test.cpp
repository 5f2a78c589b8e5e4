/// The window, drawn on a virtual screen.
#include "command.hpp"
#include "image.hpp"

namespace {

class SandboxTest : public cli::CommandTest {};

const std::string kScreen = "xvfb-run --auto-servernum";
const std::string kSmall = " --resolution 320x200 --size 64 --cascades 2 --frames 4";

TEST_F(SandboxTest, WritesTheLastFrame) {
  succeed("sandbox", "--validate --screenshot a.png" + kSmall, kScreen);
  EXPECT_EQ(files(), std::vector<std::string>{"a.png"});
  const cli::Image image = cli::readImage(path("a.png"));
  EXPECT_EQ(image.width, 320);
  EXPECT_EQ(image.height, 200);
  // The controls' title bar at the left is Dear ImGui's blue; the sea is at the right.
  EXPECT_GT(image.at("B", 200, 18), image.at("R", 200, 18) + 0.2);
  EXPECT_LT(image.at("R", 200, 18), 0.25);  // the sky is brighter
  succeed("sandbox", "--screenshot b.png" + kSmall, kScreen);
  EXPECT_EQ(readText("a.png"), readText("b.png"));
}

TEST_F(SandboxTest, WithoutAScreenThereIsNoDevice) {
  const cli::Outcome outcome = run("sandbox", "--frames 1", "env -u DISPLAY -u WAYLAND_DISPLAY");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.err.find("window"), std::string::npos) << outcome.err;
}

TEST_F(SandboxTest, BadInputIsRefused) {
  refused("sandbox", "--frames 0", {"--frames", "'0'", "1 to 1000000"});
  refused("sandbox", "--screenshot a.png", {"--screenshot", "'a.png'", "--frames"});
  refused("sandbox", "--frames 1 --screenshot missing/a.png", {"--screenshot", "missing/a.png"});
  refused("sandbox", "--resolution 0x0", {"--resolution", "'0x0'", "1 to 16384"});
  refused("sandbox", "--exposure 99", {"--exposure", "'99'", "-32 to 32"});
  refused("sandbox", "--wind 99", {"--wind", "'99'", "0.1 to 60"});
}

}  // namespace
