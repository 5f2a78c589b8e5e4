#include "settings_file.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>

#include "failure.hpp"

namespace common {
namespace {

/// The text that the user would have typed behind the option; none for tables, dates and booleans.
std::optional<std::string> scalarText(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* whole = node.as_integer()) return fmt::format("{}", whole->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  return std::nullopt;
}

std::optional<std::string> joinedText(const toml::node& node) {
  const toml::array* array = node.as_array();
  if (!array) return scalarText(node);
  std::string joined;
  for (const toml::node& element : *array) {
    const auto text = scalarText(element);
    if (!text) return std::nullopt;
    joined += (joined.empty() ? "" : ",") + *text;
  }
  return joined;
}

std::optional<std::vector<std::string>> texts(const toml::node& node, bool repeatable) {
  std::vector<std::string> list;
  const toml::array* array = node.as_array();
  if (!repeatable || !array) {
    const auto text = joinedText(node);
    if (!text) return std::nullopt;
    list.push_back(*text);
    return list;
  }
  for (const toml::node& element : *array) {
    const auto text = joinedText(element);
    if (!text) return std::nullopt;
    list.push_back(*text);
  }
  return list;
}

std::string keys(const Fields& fields) {
  std::string list;
  for (const Field& field : fields) list += (list.empty() ? "" : ", ") + field.name;
  return list;
}

}  // namespace

std::string readTextFile(const std::string& option, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  // An empty file is one, though operator<< calls it a failure to have copied nothing.
  const bool empty = file && file.peek() == std::ifstream::traits_type::eof() && !file.bad();
  if (file && !empty) text << file.rdbuf();
  if (!empty && (!file || !text)) refuse(option, path, "a file that can be read");
  return text.str();
}

void applySettings(const std::string& name, std::string_view text, const Fields& fields) {
  toml::table table;
  try {
    table = toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    throw Failure(ExitCode::badInput,
                  fmt::format("{}:{}: {}, allowed: TOML", name, error.source().begin.line, error.description()));
  }
  const auto lineOf = [&name](const toml::key& key) {
    return fmt::format("{}:{}: {}", name, key.source().begin.line, key.str());
  };
  for (const auto& [key, node] : table) {
    const bool known = std::any_of(fields.begin(), fields.end(), [&](const Field& f) { return f.name == key.str(); });
    if (!known) {
      throw Failure(ExitCode::badInput, fmt::format("{} is an unknown key, allowed: {}", lineOf(key), keys(fields)));
    }
  }
  for (const Field& field : fields) {
    const auto entry = table.find(field.name);
    if (entry == table.end()) continue;
    const std::string where = lineOf(entry->first);
    const auto values = texts(entry->second, field.repeatable);
    if (!values)
      throw Failure(ExitCode::badInput, fmt::format("{} has the wrong type, allowed: {}", where, field.help));
    field.set(where, *values);
  }
}

}  // namespace common
