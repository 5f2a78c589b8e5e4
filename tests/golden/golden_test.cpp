#include "compare.hpp"
#include "draw.hpp"
#include "support/gpu_test.hpp"

namespace {

class Golden : public support::GpuTest, public testing::WithParamInterface<std::string> {};

TEST_P(Golden, SceneLooksAsBefore) {
  const golden::Picture actual = golden::draw(gpu(), gpu().info(), golden::builtin(GetParam()));
  // For whoever looks into a failure; golden_update writes the golden itself.
  const std::filesystem::path drawn = std::filesystem::path("golden") / (GetParam() + ".png");
  golden::writePng(drawn, actual);
  ASSERT_TRUE(std::filesystem::exists(golden::imageOf(GetParam()))) << "there is no golden; drawn: " << drawn;
  for (const std::string& finding : golden::compare(golden::readPng(golden::imageOf(GetParam())), actual)) {
    ADD_FAILURE() << GetParam() << ": " << finding << "; drawn: " << std::filesystem::absolute(drawn);
  }
}

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const common::BuiltinScene& scene : common::builtinScenes()) names.emplace_back(scene.name);
  return names;
}

std::string testName(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(sceneNames()), testName);

TEST(GoldenScenes, AreFive) { EXPECT_GE(sceneNames().size(), 5u); }

}  // namespace
