/// Numbers that a host gives, and the ranges that they must lie in.
#pragma once

#include <gpu/context.hpp>
#include <initializer_list>
#include <sstream>
#include <string>

namespace pelagic::gpu {

struct Field {
  std::string name;
  double value, low, high;
  const char* range;  ///< In words, with the unit.
};

/// Names the first field that does not lie in its range, with `owner` before it.
inline Result<void> check(const std::string& owner, std::initializer_list<Field> fields) {
  for (const Field& field : fields) {
    // Written so that NaN fails.
    if (field.value >= field.low && field.value <= field.high) continue;
    std::ostringstream text;
    text << owner << field.name << " is " << field.value << ", it must be " << field.range;
    return reject(text.str());
  }
  return {};
}

}  // namespace pelagic::gpu
