#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "shared_structs.hpp"

namespace {

/// Names and offsets of the structs in a SPIR-V module.
struct Reflection {
  struct Struct {
    std::string name;
    std::map<std::uint32_t, std::string> members;
    std::map<std::uint32_t, std::uint32_t> offsets;
  };
  std::map<std::uint32_t, Struct> structs;          // by type id
  std::map<std::uint32_t, std::uint32_t> elements;  // array type: element type
  std::map<std::uint32_t, std::uint32_t> strides;   // array type: bytes
};

std::string literal(std::span<const std::uint32_t> words) {
  return reinterpret_cast<const char*>(words.data());  // zero-terminated by the format
}

// SPIR-V 1.5, sections 2.3 (layout of a module) and 3.37 (instructions).
Reflection reflect(std::span<const std::uint32_t> module) {
  constexpr std::uint32_t kName = 5, kMemberName = 6, kArray = 28, kRuntimeArray = 29, kDecorate = 71,
                          kMemberDecorate = 72;
  constexpr std::uint32_t kArrayStride = 6, kOffset = 35;
  constexpr std::size_t kHeaderWords = 5;
  Reflection result;
  for (std::size_t at = kHeaderWords; at < module.size(); at += module[at] >> 16) {
    const std::uint32_t operation = module[at] & 0xffff;
    const auto operands = module.subspan(at + 1, (module[at] >> 16) - 1);
    if (operation == kName) result.structs[operands[0]].name = literal(operands.subspan(1));
    if (operation == kMemberName) result.structs[operands[0]].members[operands[1]] = literal(operands.subspan(2));
    if (operation == kArray || operation == kRuntimeArray) result.elements[operands[0]] = operands[1];
    if (operation == kDecorate && operands[1] == kArrayStride) result.strides[operands[0]] = operands[2];
    if (operation == kMemberDecorate && operands[2] == kOffset) {
      result.structs[operands[0]].offsets[operands[1]] = operands[3];
    }
  }
  return result;
}

/// What differs between C++ and the module, a sentence each.
std::vector<std::string> differences(const layout::SharedStruct& shared) {
  const Reflection module = reflect(shared.module);
  std::vector<std::string> found;
  const auto expect = [&](const std::string& what, std::size_t cpp, std::size_t glsl) {
    if (cpp != glsl) {
      found.push_back(shared.name + what + " is " + std::to_string(cpp) + " in C++, " + std::to_string(glsl) +
                      " in GLSL");
    }
  };
  int layouts = 0, ends = 0, arrays = 0;
  for (const auto& [id, type] : module.structs) {
    if (type.name == shared.name && !type.offsets.empty()) {
      ++layouts;
      expect("'s number of members", shared.members.size(), type.offsets.size());
      for (const auto& [index, offset] : type.offsets) {
        if (index >= shared.members.size()) break;
        expect("." + shared.members[index].name + "'s name", shared.members[index].name == type.members.at(index),
               true);
        expect("." + shared.members[index].name + "'s offset", shared.members[index].offset, offset);
      }
    }
    // What follows the struct in a block, which the layouts may align to 16 bytes.
    if (type.name.starts_with(shared.name + "Block")) {
      ++ends;
      const std::size_t end = type.offsets.at(1);
      if (end != shared.size) expect("'s padded size", (shared.size + 15) / 16 * 16, end);
    }
  }
  for (const auto& [array, stride] : module.strides) {
    const auto element = module.structs.find(module.elements.at(array));
    if (element == module.structs.end() || element->second.name != shared.name) continue;
    ++arrays;
    expect("'s stride", shared.size, stride);
  }
  if (layouts == 0 || ends != 2 || arrays == 0) found.push_back(shared.name + " is not in the module");
  return found;
}

TEST(Layout, SharedStructsAreTheSameInCppAndGlsl) {
  EXPECT_GE(kSharedStructs.size(), 2u);
  for (const layout::SharedStruct& shared : kSharedStructs) {
    for (const std::string& difference : differences(shared)) ADD_FAILURE() << difference;
  }
}

TEST(Layout, DifferencesAreFound) {
  const auto sampling = std::find_if(kSharedStructs.begin(), kSharedStructs.end(),
                                     [](const layout::SharedStruct& shared) { return shared.name == "WaveSampling"; });
  ASSERT_NE(sampling, kSharedStructs.end());
  EXPECT_TRUE(differences(*sampling).empty());
  layout::SharedStruct moved = *sampling;
  moved.members[1].offset += 4;
  EXPECT_FALSE(differences(moved).empty());
  layout::SharedStruct renamed = *sampling;
  renamed.members[3].name = "other";
  EXPECT_FALSE(differences(renamed).empty());
  layout::SharedStruct longer = *sampling;
  longer.size += 4;
  EXPECT_FALSE(differences(longer).empty());
  layout::SharedStruct shorter = *sampling;
  shorter.members.pop_back();
  EXPECT_FALSE(differences(shorter).empty());
}

}  // namespace
