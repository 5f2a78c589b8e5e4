#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "rules.hpp"

namespace {

using house::Findings;
using house::Tree;

const Tree& project() {
  static const Tree tree = house::readTree(PELAGIC_ROOT);
  return tree;
}

void expectNone(const Findings& findings) {
  for (const std::string& finding : findings) ADD_FAILURE() << finding;
}

/// Exit status of clang-format's check over `files`.
int formatStatus(const std::string& files) {
  const std::string command =
      std::string(PELAGIC_CLANG_FORMAT) + " --style=file:" PELAGIC_ROOT "/.clang-format --dry-run -Werror " + files;
  return std::system(command.c_str());
}

TEST(House, TreeIsRead) {
  EXPECT_GT(project().size(), 50u);
  EXPECT_TRUE(house::find(project(), "lib/gpu/device.cpp"));
  EXPECT_TRUE(house::find(project(), ".ci/run"));
}

TEST(House, IncludesKeepToTheLayers) { expectNone(house::includeRules(project())); }

TEST(House, IncludeRulesCatch) {
  const Tree rooms{{"include/pelagic/a.hpp", ""}, {"lib/gpu/b.hpp", ""},      {"lib/waves/c.hpp", ""},
                   {"shaders/sky/d.glsl", ""},    {"shaders/shared/e.h", ""}, {"examples/common/f.hpp", ""}};
  const auto findings = [&](const std::string& path, const std::string& name) {
    Tree tree = rooms;
    tree.push_back({path, "// first\n#include <" + name + ">\n"});
    return house::includeRules(tree).size();
  };
  EXPECT_EQ(findings("include/pelagic/x.hpp", "gpu/b.hpp"), 1u);
  EXPECT_EQ(findings("include/pelagic/x.hpp", "fmt/core.h"), 1u);
  EXPECT_EQ(findings("include/pelagic/x.hpp", "vulkan/vulkan.hpp"), 1u);
  EXPECT_EQ(findings("include/pelagic/x.hpp", "pelagic/a.hpp"), 0u);
  EXPECT_EQ(findings("include/pelagic/x.hpp", "vector"), 0u);
  EXPECT_EQ(findings("lib/gpu/x.cpp", "waves/c.hpp"), 1u);
  EXPECT_EQ(findings("lib/sky/x.cpp", "waves/c.hpp"), 1u);
  EXPECT_EQ(findings("lib/sky/x.cpp", "shared/e.h"), 0u);
  EXPECT_EQ(findings("lib/sky/x.cpp", "sky/d.glsl"), 0u);
  EXPECT_EQ(findings("lib/waves/x.cpp", "sky/d.glsl"), 1u);
  EXPECT_EQ(findings("lib/sky/x.cpp", "CLI/CLI.hpp"), 1u);
  EXPECT_EQ(findings("lib/ocean.cpp", "waves/c.hpp"), 0u);
  EXPECT_EQ(findings("shaders/waves/x.comp", "sky/d.glsl"), 1u);
  EXPECT_EQ(findings("examples/render/x.cpp", "waves/c.hpp"), 1u);
  EXPECT_EQ(findings("examples/render/x.cpp", "common/f.hpp"), 0u);
  EXPECT_EQ(findings("tests/golden/x.cpp", "gpu/b.hpp"), 1u);
}

TEST(House, BindingsAreReadOnlyOrWriteOnly) { expectNone(house::bindingRules(project())); }

TEST(House, BindingRulesCatch) {
  const auto findings = [](const std::string& text) {
    return house::bindingRules({{"shaders/waves/x.comp", text}}).size();
  };
  EXPECT_EQ(findings("layout(set = 0, binding = 1, std430) buffer B { vec4 v[]; };"), 1u);
  EXPECT_EQ(findings("layout(binding = 1, rgba16f) uniform image2DArray map;"), 1u);
  EXPECT_EQ(findings("layout(binding = 1)\n  uniform uimage2D map;"), 1u);
  EXPECT_EQ(findings("layout(binding = 1, std430) readonly buffer B { vec4 v[]; };"), 0u);
  EXPECT_EQ(findings("layout(binding = 1) uniform writeonly image2D map;"), 0u);
  EXPECT_EQ(findings("layout(binding = 1) uniform sampler2D map; layout(binding = 2) uniform samplerBuffer rows;"), 0u);
  EXPECT_EQ(findings("layout(binding = 1) uniform Block { vec4 v; };"), 0u);
  EXPECT_EQ(findings("// layout(binding = 1) buffer B { vec4 v[]; };"), 0u);
}

TEST(House, NothingReturnsBeforeABarrier) { expectNone(house::barrierRules(project())); }

TEST(House, BarrierRulesCatch) {
  const auto findings = [](const std::string& text) {
    return house::barrierRules(
               {{"shaders/shared/w.glsl", "void wait() { barrier(); }"}, {"shaders/waves/x.comp", text}})
        .size();
  };
  EXPECT_EQ(findings("void main() { if (outside) return; barrier(); }"), 1u);
  EXPECT_EQ(findings("#include \"shared/w.glsl\"\nvoid main() { if (outside) { return; } wait(); }"), 1u);
  EXPECT_EQ(findings("float f() { return 1; }\nvoid main() { f(); barrier(); if (outside) return; store(); }"), 0u);
}

TEST(House, LoopsDoNotEndAtUniforms) { expectNone(house::loopRules(project())); }

TEST(House, LoopRulesCatch) {
  const auto findings = [](const std::string& text) {
    return house::loopRules({{"shaders/composite/x.comp", text}}).size();
  };
  EXPECT_EQ(findings("for (uint c = 0u; c < frame.waves.cascades; ++c) {}"), 1u);
  EXPECT_EQ(findings("do { add(i); } while (++i < frame.hostLights);"), 1u);
  EXPECT_EQ(findings("for (uint c = 0u; c < notWrittenIn(frame.waves.cascades); ++c) {}"), 0u);
  EXPECT_EQ(findings("do { add(i); } while (++i < count); bool less = i < frame.hostLights;"), 0u);
}

TEST(House, FilesAreShort) { expectNone(house::lengthRules(project())); }

TEST(House, LengthRulesCatch) {
  EXPECT_EQ(house::lengthRules({{"lib/gpu/x.cpp", std::string(451, '\n')}}).size(), 1u);
  EXPECT_EQ(house::lengthRules({{"lib/gpu/x.cpp", std::string(450, '\n')}}).size(), 0u);
}

TEST(House, NoForbiddenWords) { expectNone(house::wordRules(project())); }

TEST(House, WordRulesCatch) {
  for (const std::string word : {"// TO"
                                 "DO later",
                                 "/* FIX"
                                 "ME */",
                                 "TEST(A, DISABLE"
                                 "D_B)",
                                 "open(\"/wor"
                                 "k/main\")"}) {
    EXPECT_EQ(house::wordRules({{"lib/x.cpp", word}}).size(), 1u) << word;
  }
  EXPECT_EQ(house::wordRules({{"lib/x.cpp", "the network/home of the wave"}}).size(), 0u);
}

TEST(House, FilesAreSmall) { expectNone(house::sizeRules(PELAGIC_ROOT)); }

TEST(House, SizeRulesCatch) {
  const std::filesystem::path root = std::filesystem::path(testing::TempDir()) / "pelagic_house_size";
  std::filesystem::create_directories(root / "docs");
  std::ofstream(root / "docs/large.png") << std::string(200001, 'x');
  EXPECT_EQ(house::sizeRules(root).size(), 1u);
  std::filesystem::resize_file(root / "docs/large.png", 200000);
  EXPECT_EQ(house::sizeRules(root).size(), 0u);
  std::filesystem::remove_all(root);
}

TEST(House, CodeIsFormatted) {
  std::string files;
  for (const house::File& file : project()) {
    if (house::isCode(file.path)) files.append(" '" PELAGIC_ROOT "/").append(file.path).append("'");
  }
  EXPECT_EQ(formatStatus(files), 0);
}

TEST(House, FormatCheckCatches) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "pelagic_house_format.cpp";
  std::ofstream(file) << "int  f( ){return 1 ;}\n";
  EXPECT_NE(formatStatus(file.string() + " 2>/dev/null"), 0);
  std::filesystem::remove(file);
}

}  // namespace
