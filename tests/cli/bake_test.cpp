/// The sea as data: names, types, layout and what the numbers must have in common.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numeric>

#include "command.hpp"
#include "image.hpp"
#include "spectral.hpp"

namespace {

constexpr int kSize = 64;
const std::string kSmall = " --size 64 --cascades 2";

class BakeTest : public cli::CommandTest {
 protected:
  cli::Image cascade(const std::string& name) const { return cli::readImage(path("sea") / name); }
};

std::vector<std::string> keys(const nlohmann::json& object) {
  std::vector<std::string> list;
  for (const auto& [key, value] : object.items()) list.push_back(key);
  return list;  // sorted, as nlohmann::json keeps them
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

TEST_F(BakeTest, WritesWhatTheContractNames) {
  succeed("bake", "--output sea --frames 2 --fps 10 --variance" + kSmall);
  EXPECT_EQ(files(),
            (std::vector<std::string>{"sea", "sea/c0.0000.exr", "sea/c0.0001.exr", "sea/c1.0000.exr", "sea/c1.0001.exr",
                                      "sea/sea.json", "sea/variance.c0.exr", "sea/variance.c1.exr"}));
  const cli::Image maps = cascade("c1.0001.exr");
  EXPECT_EQ(maps.width, kSize);
  EXPECT_EQ(maps.height, kSize);
  EXPECT_EQ(maps.types, (std::map<std::string, std::string>{{"displacement.X", "float"},
                                                            {"displacement.Y", "float"},
                                                            {"displacement.Z", "float"},
                                                            {"slope.X", "float"},
                                                            {"slope.Z", "float"},
                                                            {"gradient.XX", "float"},
                                                            {"gradient.ZZ", "float"},
                                                            {"gradient.XZ", "float"},
                                                            {"jacobian.V", "float"},
                                                            {"foam.V", "float"}}));
  EXPECT_EQ(cascade("variance.c0.exr").types, (std::map<std::string, std::string>{{"variance.V", "float"}}));
}

TEST_F(BakeTest, DocumentHasTheContractsKeys) {
  succeed("bake",
          "--output sea --frames 3 --fps 10 --wind 12 --wind-direction 90 --fetch 50 --depth 20 --spectrum tma "
          "--spreading cos2 --choppiness 0.5 --seed 18446744073709551615 --loop 100" +
              kSmall);
  const nlohmann::json sea = readJson("sea/sea.json");
  EXPECT_EQ(keys(sea),
            (std::vector<std::string>{"cascades", "choppiness", "depth_m", "fetch_m", "gravity", "hs_m",
                                      "loop_period_s", "mss", "seed", "spectrum", "spreading", "times_s", "tp_s",
                                      "version", "whitecap_fraction", "wind_direction_rad", "wind_m_s"}));
  EXPECT_EQ(keys(sea["cascades"][0]), (std::vector<std::string>{"k_max", "k_min", "length_m", "size"}));
  EXPECT_EQ(keys(sea["hs_m"]), (std::vector<std::string>{"grid", "target"}));
  EXPECT_EQ(keys(sea["mss"]), (std::vector<std::string>{"grid_crosswind", "grid_upwind", "target_crosswind",
                                                        "target_upwind", "unresolved_crosswind", "unresolved_upwind"}));
  EXPECT_EQ(sea["version"], PELAGIC_VERSION);
  EXPECT_EQ(sea["seed"], 18446744073709551615u);
  EXPECT_EQ(sea["spectrum"], "tma");
  EXPECT_EQ(sea["spreading"], "cos2");
  EXPECT_EQ(sea["wind_m_s"], 12);
  EXPECT_DOUBLE_EQ(sea["wind_direction_rad"], std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(sea["fetch_m"], 50000);
  EXPECT_EQ(sea["depth_m"], 20);
  EXPECT_EQ(sea["choppiness"], 0.5);
  EXPECT_EQ(sea["loop_period_s"], 100);
  EXPECT_EQ(sea["gravity"], 9.81);
  EXPECT_EQ(sea["times_s"], (std::vector<double>{0, 0.1, 0.2}));
  ASSERT_EQ(sea["cascades"].size(), 2u);
  EXPECT_EQ(sea["cascades"][1]["size"], kSize);
  // Cox & Munk: 0.00316 U up-wind, 0.003 + 0.00192 U across.
  EXPECT_NEAR(sea["mss"]["target_upwind"], 0.00316 * 12, 1e-9);
  EXPECT_NEAR(sea["mss"]["target_crosswind"], 0.003 + 0.00192 * 12, 1e-9);
  EXPECT_NEAR(sea["whitecap_fraction"], 3.84e-6 * std::pow(12, 3.41), 1e-9);
}

TEST_F(BakeTest, DefaultsAreTheContracts) {
  succeed("bake", "--output sea --variance");
  const nlohmann::json sea = readJson("sea/sea.json");
  EXPECT_EQ(sea["wind_m_s"], 8);
  EXPECT_EQ(sea["wind_direction_rad"], 0);
  EXPECT_EQ(sea["fetch_m"], 100000);
  EXPECT_TRUE(sea["depth_m"].is_null());
  EXPECT_EQ(sea["spectrum"], "jonswap");
  EXPECT_EQ(sea["spreading"], "hasselmann");
  EXPECT_EQ(sea["choppiness"], 1);
  EXPECT_EQ(sea["seed"], 1);
  EXPECT_EQ(sea["loop_period_s"], 4194304);
  ASSERT_EQ(sea["cascades"].size(), 4u);
  EXPECT_EQ(sea["cascades"][0]["size"], 256);
  EXPECT_NEAR(static_cast<double>(sea["hs_m"]["grid"]) / static_cast<double>(sea["hs_m"]["target"]), 1, 0.03);
  double variance = 0;
  for (int c = 0; c < 4; ++c) variance += sum(cascade(fmt::format("variance.c{}.exr", c))["variance.V"]);
  EXPECT_NEAR(4 * std::sqrt(variance) / static_cast<double>(sea["hs_m"]["grid"]), 1, 1e-4);
}

TEST_F(BakeTest, TakesMeasuredSpectra) {
  // A triangle of 0.6, trapezia of 0.7 and 0.2 and a tail of 4 x 0.2 / 4 m^2.
  writeFile("buoy.csv", "# f [Hz], S [m^2/Hz]\n0.05,0\n0.1, 24\n\n0.15,4\r\n0.2,4\n");
  succeed("bake", "--output sea --spectrum buoy.csv" + kSmall);
  const nlohmann::json sea = readJson("sea/sea.json");
  EXPECT_EQ(sea["spectrum"], "table");
  EXPECT_NEAR(sea["hs_m"]["target"], 4 * std::sqrt(0.6 + 0.7 + 0.2 + 0.2), 0.01);
  EXPECT_NEAR(sea["tp_s"], 10, 1e-9);
}

TEST_F(BakeTest, DirectionsOfMeasuredSpectraAreThoseOfTheWorld) {
  // All waves run toward +z, 90 degrees, though the wind blows toward +x: crests lie along x.
  writeFile("sea.csv", "f,60,90,120,270\n0.08,0,1,0,0\n0.1,0,4,0,0\n0.2,0,1,0,0\n");
  succeed("bake", "--output sea --spectrum sea.csv --wind-direction 0" + kSmall);
  const nlohmann::json mss = readJson("sea/sea.json")["mss"];
  EXPECT_GT(static_cast<double>(mss["grid_crosswind"]), 10 * static_cast<double>(mss["grid_upwind"]));
}

TEST_F(BakeTest, BadSpectrumFilesAreRefusedWithTheirLine) {
  writeFile("a.csv", "0.1,1\n0.2,-1\n");
  refused("bake", "--output sea --spectrum a.csv", {"--spectrum a.csv:2", "'-1'", "0 to 1000000 m^2/Hz"});
  writeFile("b.csv", "0.1,1\n0.2,1,3\n");
  refused("bake", "--output sea --spectrum b.csv", {"--spectrum b.csv:2", "'0.2,1,3'", "2 numbers with commas"});
  writeFile("c.csv", "0.1,1\n");
  refused("bake", "--output sea --spectrum c.csv", {"--spectrum", "'c.csv'", "at least two rows"});
  writeFile("d.csv", "0.2,1\n0.1,1\n");
  refused("bake", "--output sea --spectrum d.csv", {"SeaState::table.frequency[1]", "0.1", "exceed"});
}

TEST_F(BakeTest, SlopesAndGradientsAreTheDerivatives) {
  succeed("bake", "--output sea --time 12 --wind-direction 30 --choppiness 0.8" + kSmall);
  for (std::size_t c = 0; c < 2; ++c) {
    const double length = readJson("sea/sea.json")["cascades"][c]["length_m"];
    const cli::Image maps = cascade(fmt::format("c{}.0000.exr", c));
    const auto expectDerivative = [&](const char* channel, const char* of, cli::Axis axis) {
      const auto exact = cli::derivative(maps[of], kSize, length, axis);
      EXPECT_LT(cli::relativeError(maps[channel], exact), 1e-4) << channel << " of cascade " << c;
    };
    expectDerivative("slope.X", "displacement.Y", cli::Axis::x);
    expectDerivative("slope.Z", "displacement.Y", cli::Axis::z);
    expectDerivative("gradient.XX", "displacement.X", cli::Axis::x);
    expectDerivative("gradient.ZZ", "displacement.Z", cli::Axis::z);
    expectDerivative("gradient.XZ", "displacement.Z", cli::Axis::x);
    double correlation = 0;  // of height and convergence: the displacement goes toward the crests
    for (std::size_t i = 0; i < maps["slope.X"].size(); ++i) {
      const double xx = maps["gradient.XX"][i];
      const double zz = maps["gradient.ZZ"][i];
      const double xz = maps["gradient.XZ"][i];
      EXPECT_NEAR(maps["jacobian.V"][i], (1 + xx) * (1 + zz) - xz * xz, 1e-5);
      EXPECT_GE(maps["foam.V"][i], 0);
      EXPECT_LE(maps["foam.V"][i], 1);
      correlation += maps["displacement.Y"][i] * (xx + zz);
    }
    EXPECT_LT(correlation, 0);
  }
}

/// Energy of modes with kx kz > 0, and half of that on the axes, over that of all.
double diagonalShare(const std::vector<double>& energy) {
  double share = 0;
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) {
      const int product = cli::modeOf(row, kSize) * cli::modeOf(column, kSize);
      const double weight = product > 0 ? 1 : product == 0 ? 0.5 : 0;
      share += weight * energy[static_cast<std::size_t>(row * kSize + column)];
    }
  }
  return share / sum(energy);
}

TEST_F(BakeTest, VarianceIsThatOfTheHeightsModes) {
  succeed("bake", "--output sea --variance --wind-direction 45 --spreading cos2" + kSmall);
  const nlohmann::json sea = readJson("sea/sea.json");
  double total = 0;
  for (std::size_t c = 0; c < 2; ++c) {
    const std::vector<double> variance = cascade(fmt::format("variance.c{}.exr", c))["variance.V"];
    const auto modes = cli::transform(cascade(fmt::format("c{}.0000.exr", c))["displacement.Y"], kSize);
    const nlohmann::json& band = sea["cascades"][c];
    std::vector<double> energy(modes.size());
    for (std::size_t i = 0; i < modes.size(); ++i) {
      energy[i] = std::norm(modes[i]);
      const double k =
          2 * std::numbers::pi / static_cast<double>(band["length_m"]) *
          std::hypot(cli::modeOf(static_cast<int>(i) / kSize, kSize), cli::modeOf(static_cast<int>(i) % kSize, kSize));
      if (k < static_cast<double>(band["k_min"]) || k >= static_cast<double>(band["k_max"])) {
        EXPECT_EQ(variance[i], 0) << "mode " << i;
      }
      // A mode without variance has no energy; |h|^2 / E|h|^2 is exponential: beyond 30 once in 1e13 modes.
      EXPECT_LE(energy[i], 30 * variance[i] + 1e-12) << "mode " << i;
    }
    // cos^2 spreading puts 1/2 + 1/pi = 0.82 of the energy into the wind's quadrant; mirrored it would be 0.18.
    EXPECT_NEAR(diagonalShare(variance), 0.5 + 1 / std::numbers::pi, 0.03);
    EXPECT_GT(diagonalShare(energy), 0.65);
    EXPECT_NEAR(sum(energy) / sum(variance), 1, 0.5);
    total += sum(variance);
  }
  EXPECT_NEAR(4 * std::sqrt(total) / static_cast<double>(sea["hs_m"]["grid"]), 1, 1e-4);
}

TEST_F(BakeTest, TheSeaRepeatsAfterItsLoop) {
  succeed("bake", "--output sea --loop 5 --frames 2 --fps 0.2" + kSmall);
  EXPECT_EQ(cascade("c0.0000.exr")["displacement.Y"], cascade("c0.0001.exr")["displacement.Y"]);
}

TEST_F(BakeTest, OptionsOverrideTheFile) {
  writeFile("sea.toml", "wind = 11\nfetch = 30\nswell = [[2, 12, 40], [1, 9, -30, 50]]\nsize = 64\ncascades = 1\n");
  succeed("bake", "--fetch 40 --output a --sea sea.toml");
  EXPECT_EQ(readJson("a/sea.json")["wind_m_s"], 11);
  EXPECT_EQ(readJson("a/sea.json")["fetch_m"], 40000);
  EXPECT_EQ(readJson("a/sea.json")["cascades"].size(), 1u);
  succeed("bake", "--sea sea.toml --swell none --output b");
  const double with = readJson("a/sea.json")["hs_m"]["target"];
  const double without = readJson("b/sea.json")["hs_m"]["target"];
  succeed("bake", "--sea sea.toml --fetch 40 --swell none --output c");
  const double windSea = readJson("c/sea.json")["hs_m"]["target"];
  EXPECT_LT(without, windSea);                                        // a shorter fetch
  EXPECT_NEAR(with * with, windSea * windSea + 2 * 2 + 1 * 1, 0.02);  // variances add
  succeed("bake", "--sea sea.toml --fetch 40 --swell 3,12,0 --swell 1.5,9,-30 --output d");
  const double repeated = readJson("d/sea.json")["hs_m"]["target"];
  EXPECT_NEAR(repeated * repeated, windSea * windSea + 3 * 3 + 1.5 * 1.5, 0.03);
}

TEST_F(BakeTest, TheSameInputGivesTheSameFiles) {
  succeed("bake", "--output a --time 3 --variance" + kSmall);
  succeed("bake", "--output b --time 3 --variance" + kSmall);
  for (const char* name : {"c0.0000.exr", "c1.0000.exr", "variance.c0.exr", "sea.json"}) {
    EXPECT_EQ(readText(fmt::format("a/{}", name)), readText(fmt::format("b/{}", name))) << name;
  }
  succeed("bake", "--output c --time 3 --seed 2" + kSmall);
  EXPECT_NE(readText("a/c0.0000.exr"), readText("c/c0.0000.exr"));
}

TEST_F(BakeTest, AMessageOfTheLayerFailsAndLeavesNothing) {
  // Advice for other vendors' devices: messages that need no mistake of the library.
  setenv("VK_LAYER_ENABLES", "VALIDATION_CHECK_ENABLE_VENDOR_SPECIFIC_ALL", 1);
  const cli::Outcome outcome = run("bake", "--validate --output sea" + kSmall);
  unsetenv("VK_LAYER_ENABLES");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err, "");
  EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(BakeTest, ValidationIsSilent) { succeed("bake", "--validate --output sea --variance" + kSmall); }

}  // namespace
