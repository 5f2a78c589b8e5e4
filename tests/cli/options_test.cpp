/// Bad input of pelagic-bake, and of every option that it shares with the others: status 2 and one line.
#include <algorithm>

#include "bad_values.hpp"
#include "command.hpp"

namespace {

class OptionsTest : public cli::CommandTest {
 protected:
  void refuseAll(const std::vector<cli::Bad>& list) const {
    for (const cli::Bad& bad : list) {
      const std::string output = bad.option == std::string("--output") ? "" : "--output sea ";
      for (const char* value : bad.values) refused("bake", output + bad.option + " " + value, answer(bad, value));
    }
  }
};

TEST_F(OptionsTest, SeaOutOfRange) { refuseAll(cli::badSea()); }
TEST_F(OptionsTest, TimeOutOfRange) { refuseAll(cli::badTime()); }
TEST_F(OptionsTest, OutputThatCannotBe) { refuseAll({{"--output", {"/proc/sea", "''"}, ""}}); }

TEST_F(OptionsTest, ContradictionsAreRefused) {
  const std::string output = " --output sea";
  refused("bake", "--time 3 --frames 2 --fps 10" + output, {"--time", "'3'", "--frames"});
  refused("bake", "--fps 10" + output, {"--fps", "'10'", "--frames"});
  refused("bake", "--wind 3 --wind 4" + output, {"--wind"});
  refused("bake", "--wind", {"--wind", "0.1 to 60 m/s"});
  refused("bake", "--wind --depth 5" + output, {"--wind", "'--depth'"});
  refused("bake", "--bogus 5" + output, {"--bogus"});
  refused("bake", "stray" + output, {"stray"});
  refused("bake", "", {"--output"});
}

TEST_F(OptionsTest, UnknownDevicesAreRefused) {
  refused("bake", "--output sea --device nosuchdevice", {"--device", "nosuchdevice", "allowed: 0 '"});
  refused("bake", "--output sea --device 99", {"--device", "'99'", "allowed: 0 '"});
  refused("bake", "--output sea --device ''", {"--device", "''"});
}

TEST_F(OptionsTest, FilesAreAnsweredWithTheirLine) {
  writeFile("sea.toml", "wind = 8\nwnd = 9\n");
  refused("bake", "--output sea --sea sea.toml", {"sea.toml:2", "wnd", "allowed: ", "wind, "});
  writeFile("sea.toml", "\n\nwind = 99\n");
  refused("bake", "--output sea --sea sea.toml", {"sea.toml:3", "wind", "'99'", "0.1 to 60 m/s"});
  writeFile("sea.toml", "wind = [1, { a = 2 }]\n");
  refused("bake", "--output sea --sea sea.toml", {"sea.toml:1", "wind"});
  writeFile("sea.toml", "wind = 8\nwind 9\n");
  refused("bake", "--output sea --sea sea.toml", {"sea.toml:2"});
  writeFile("sea.toml", "wind = 8\nwind = 9\n");
  refused("bake", "--output sea --sea sea.toml", {"sea.toml:2"});
  writeFile("sea.toml", "exposure = 2\n");
  refused("bake", "--output sea --sea sea.toml", {"sea.toml:1", "exposure"});
}

TEST_F(OptionsTest, HelpAndVersion) {
  for (const std::string program : {"bake", "query", "render", "minimal", "sandbox"}) {
    const cli::Outcome help = run(program, "--help");
    EXPECT_EQ(help.status, 0);
    EXPECT_EQ(help.err, "");
    for (const char* option : {"--help", "--version", "--device", "--validate"}) {
      EXPECT_NE(help.out.find(option), std::string::npos) << program << " " << option;
    }
    const cli::Outcome version = run(program, "--version");
    EXPECT_EQ(version.status, 0);
    EXPECT_EQ(version.out, "pelagic-" + program + " " PELAGIC_VERSION "\n");
    EXPECT_EQ(files(), std::vector<std::string>{});
  }
}

TEST_F(OptionsTest, WithoutADeviceNothingIsWritten) {
  const cli::Outcome outcome =
      run("bake", "--output sea", "env VK_DRIVER_FILES=/nonexistent VK_ICD_FILENAMES=/nonexistent");
  EXPECT_EQ(outcome.status, 4) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_TRUE(files().empty());
}

TEST_F(OptionsTest, MinimalWritesItsPicture) {
  succeed("minimal", "--validate --device 0");
  EXPECT_EQ(files(), std::vector<std::string>{"minimal.png"});
  std::filesystem::remove(path("minimal.png"));
  refused("minimal", "--wind 3", {"--wind"});
}

}  // namespace
