/// Bad values of options, and what is said about them.
#pragma once

#include <string>
#include <vector>

namespace cli {

struct Bad {
  const char* option;
  std::vector<const char*> values;  ///< Words of a shell.
  const char* allowed;              ///< Part of the answer, where the value is not empty.
};

/// Of options that programs share.
const std::vector<Bad>& badSea();
const std::vector<Bad>& badTime();
/// What has to be in the line about `value`.
std::vector<std::string> answer(const Bad& bad, const std::string& value);

}  // namespace cli
