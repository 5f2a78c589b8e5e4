/// Points on the sea as a table: the same from CPU and GPU, and bad input.
#include <cmath>
#include <sstream>

#include "command.hpp"

namespace {

const std::string kSmall = " --size 64 --cascades 2 ";
constexpr std::size_t kNumbers = 13;

struct Row {
  std::vector<double> numbers;
  std::string source;
};

class QueryTest : public cli::CommandTest {
 protected:
  std::vector<Row> table(const std::string& name) const {
    std::istringstream lines(readText(name));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "time,x,z,height,nx,ny,nz,vx,vy,vz,ax,ay,az,source");
    std::vector<Row> rows;
    while (std::getline(lines, line)) {
      Row row;
      std::istringstream cells(line);
      std::string cell;
      for (std::size_t i = 0; i < kNumbers && std::getline(cells, cell, ','); ++i)
        row.numbers.push_back(std::stod(cell));
      std::getline(cells, row.source);
      EXPECT_EQ(row.numbers.size(), kNumbers) << line;
      rows.push_back(row);
    }
    return rows;
  }
};

TEST_F(QueryTest, BothSourcesAnswerEveryPointAtEveryTime) {
  writeFile("points.csv", "# x,z\n0,0\r\n\n 12.5 , -40\n1234567.125,-1e6\n");
  succeed("query", "--points points.csv --time 0,-3.5,2592000.25 --output sea.csv --validate --wind 12" + kSmall);
  EXPECT_EQ(files(), std::vector<std::string>{"sea.csv"});
  const std::vector<Row> rows = table("sea.csv");
  ASSERT_EQ(rows.size(), 18u);
  const double times[] = {0, -3.5, 2592000.25};
  const double places[][2] = {{0, 0}, {12.5, -40}, {1234567.125, -1e6}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].source, i % 2 == 0 ? "cpu" : "gpu");
    EXPECT_EQ(rows[i].numbers[0], times[i / 6]);
    EXPECT_EQ(rows[i].numbers[1], places[i / 2 % 3][0]);
    EXPECT_EQ(rows[i].numbers[2], places[i / 2 % 3][1]);
  }
  for (std::size_t i = 0; i < rows.size(); i += 2) {
    const auto& cpu = rows[i].numbers;
    const auto& gpu = rows[i + 1].numbers;
    for (std::size_t n = 3; n < kNumbers; ++n) EXPECT_NEAR(cpu[n], gpu[n], 1e-3) << "row " << i << " column " << n;
    EXPECT_NEAR(std::hypot(cpu[4], cpu[5], cpu[6]), 1, 1e-8);
    EXPECT_NE(cpu[3], 0);
  }
  EXPECT_NE(rows[0].numbers[3], rows[6].numbers[3]);
}

TEST_F(QueryTest, SeesTrochoidsAndMapsOfGain) {
  writeFile("points.csv", "0,0\n20,5\n");
  const std::string still = "--octave-gain 0,0,0,0,0,0,0,0,0,0,0,0";
  succeed("query", "--points points.csv --time 0 --output wave.csv --trochoid 1.5,80,0,1,0 " + still + kSmall);
  EXPECT_NEAR(table("wave.csv").at(0).numbers[3], 1.5, 1e-3) << "a crest at the origin";
  succeed("query", "--points points.csv --time 0 --output picked.csv --pick-trochoids 12,0.2,0.5" + kSmall);
  EXPECT_NE(table("picked.csv").at(0).numbers[3], 0);
  // Any image is a map: the variances of a mode are nearly 0, and so is the sea under them.
  succeed("bake", "--time 0 --output baked --variance --wind 5" + kSmall);
  succeed("query",
          "--points points.csv --time 0 --output flat.csv --gain-map baked/variance.c0.exr,-50,-50,10" + kSmall);
  for (const Row& row : table("flat.csv")) EXPECT_NEAR(row.numbers[3], 0, 0.02);
}

TEST_F(QueryTest, VelocityIsTheHeightsChangeWhereWaterOnlyRises) {
  writeFile("points.csv", "3,4\n");
  // Without choppiness the water goes up and down only.
  succeed("query", "--points points.csv --time 10,9.99,10.01 --output sea.csv --choppiness 0" + kSmall);
  const std::vector<Row> rows = table("sea.csv");
  ASSERT_EQ(rows.size(), 6u);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto height = [&](std::size_t time) { return rows[2 * time + i].numbers[3]; };
    EXPECT_NEAR(rows[i].numbers[8], (height(2) - height(1)) / 0.02, 2e-4);
    EXPECT_NEAR(rows[i].numbers[11], (height(2) - 2 * height(0) + height(1)) / 1e-4, 0.02);
    EXPECT_NEAR(rows[i].numbers[7], 0, 1e-6);
  }
}

TEST_F(QueryTest, SameInputSameBytes) {
  writeFile("points.csv", "5,6\n-7,8e3\n");
  writeFile("sea.toml", "wind = 9\nswell = [[2, 12, 30]]\nsize = 64\ncascades = 2\n");
  succeed("query", "--points points.csv --sea sea.toml --output a.csv");
  succeed("query", "--points points.csv --sea sea.toml --time 0 --output b.csv");
  EXPECT_EQ(readText("a.csv"), readText("b.csv"));
}

TEST_F(QueryTest, BadInputIsNamed) {
  const auto bad = [&](const std::string& text, const std::vector<std::string>& names) {
    writeFile("points.csv", text);
    refused("query", "--points points.csv --output sea.csv", names);
  };
  bad("1,2\n\n3\n", {"--points points.csv:3", "'3'", "allowed: x,z: two numbers with a comma between"});
  bad("1,2,3\n", {"--points points.csv:1", "'1,2,3'", "two numbers"});
  bad("x,z\n1,2\n", {"--points points.csv:1", "'x,z'", "an x of -1000000000 to 1000000000 m"});
  bad("1,2\n1,nan\n", {"--points points.csv:2", "'1,nan'", "a z of -1000000000 to 1000000000 m"});
  bad("1,2e9\n", {"--points points.csv:1", "a z of"});
  bad("", {"--points", "'points.csv'", "at least one line x,z"});
  bad("# nothing\n\n", {"--points", "'points.csv'", "at least one line x,z"});
  refused("query", "--points missing.csv --output sea.csv", {"--points", "'missing.csv'", "a file that can be read"});
  refused("query", "--output sea.csv", {"--points", "it must be given"});
  writeFile("points.csv", "1,2\n");
  refused("query", "--points points.csv", {"--output", "it must be given"});
  refused("query", "--points points.csv --output /proc/sea.csv", {"--output", "'/proc/sea.csv'"});
  for (const std::string time : {"nan", "1,2x", "1,", "1e10", "1;2"}) {
    refused("query", "--points points.csv --output sea.csv --time '" + time + "'",
            {"--time", "'" + time + "'", "numbers with commas, each -1000000000 to 1000000000 s"});
  }
  refused("query", "--points points.csv --output sea.csv --wind 99", {"--wind", "'99'"});
  refused("query", "--points points.csv --output sea.csv --device nonesuch", {"--device", "'nonesuch'"});
}

}  // namespace
