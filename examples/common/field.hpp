/// Settings as text: one definition serves a command-line option and a key of a TOML file alike.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace common {

/// What a number may be, in the unit the user types.
struct Range {
  double min = 0;
  double max = 0;
  std::string_view unit;
  bool openMin = false;  ///< `min` itself is not allowed.
};
/// "0.1 to 60 m/s".
std::string describe(const Range& range);

/// A finite or (where the range says so) infinite number. `where` names the option, or file, line and key.
/// Throws a Failure that names all of it when `text` is anything else.
double parseNumber(const std::string& where, std::string_view text, const Range& range);
std::uint64_t parseWhole(const std::string& where, std::string_view text, std::uint64_t min, std::uint64_t max);
/// One of several numbers in `text`; a Failure names the whole text and which part of it is wrong.
double parsePart(const std::string& where, std::string_view text, std::string_view part, std::string_view name,
                 const Range& range);
/// "x,y,z", every component within the same range.
glm::dvec3 parseVector(const std::string& where, std::string_view text, const Range& range);
std::vector<std::string> split(std::string_view text, char separator);
[[noreturn]] void refuse(const std::string& where, std::string_view text, std::string_view allowed);

struct Field {
  std::string name;   ///< Key of a TOML file; with "--" in front the option.
  std::string value;  ///< Placeholder in the help text.
  std::string help;
  /// Takes the whole list of a repeatable field, else one text.
  std::function<void(const std::string& where, const std::vector<std::string>& texts)> set;
  bool repeatable = false;
};
using Fields = std::vector<Field>;

/// Stores number x scale in `target`.
Field numberField(std::string name, std::string value, std::string help, const Range& range, double& target,
                  double scale = 1);
Field wholeField(std::string name, std::string value, std::string help, std::uint64_t min, std::uint64_t max,
                 std::function<void(std::uint64_t)> set);
Field vectorField(std::string name, std::string help, const Range& range, std::function<void(const glm::dvec3&)> set);

/// One of a list of names.
template <class T>
using Choices = std::vector<std::pair<std::string_view, T>>;

template <class T>
std::string names(const Choices<T>& choices) {
  std::string list;
  for (const auto& choice : choices) list += (list.empty() ? "" : ", ") + std::string(choice.first);
  return list;
}

template <class T>
T parseChoice(const std::string& where, std::string_view text, const Choices<T>& choices, const char* others = "") {
  for (const auto& choice : choices) {
    if (choice.first == text) return choice.second;
  }
  refuse(where, text, names(choices) + others);
}

/// Appends; fields refer to the same variables as before.
Fields operator+(Fields first, Fields second);

}  // namespace common
