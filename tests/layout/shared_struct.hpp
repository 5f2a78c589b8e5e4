/// A struct as C++ lays it out, and the SPIR-V module of a shader that has it in blocks.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace layout {

struct SharedStruct {
  struct Member {
    std::string name;
    std::size_t offset;
  };
  std::string name;
  std::span<const std::uint32_t> module;
  std::size_t size;
  std::vector<Member> members;
};

}  // namespace layout
