#include "field.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>

#include "failure.hpp"

namespace common {

std::string describe(const Range& range) {
  const std::string_view gap = range.unit.empty() ? "" : " ";
  return fmt::format("{}{} to {}{}{}", range.openMin ? "more than " : "", range.min,
                     std::isinf(range.max) ? "inf" : fmt::format("{}", range.max), gap, range.unit);
}

void refuse(const std::string& where, std::string_view text, std::string_view allowed) {
  throw Failure(ExitCode::badInput, fmt::format("{} is '{}', allowed: {}", where, text, allowed));
}

namespace {

std::optional<double> numberIn(std::string_view text, const Range& range) {
  double value = std::numeric_limits<double>::quiet_NaN();
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  const bool inside = (range.openMin ? value > range.min : value >= range.min) && value <= range.max;
  return whole && inside ? std::optional(value) : std::nullopt;
}

}  // namespace

double parseNumber(const std::string& where, std::string_view text, const Range& range) {
  const auto value = numberIn(text, range);
  if (!value) refuse(where, text, describe(range));
  return *value;
}

double parsePart(const std::string& where, std::string_view text, std::string_view part, std::string_view name,
                 const Range& range) {
  const auto value = numberIn(part, range);
  if (!value) refuse(where, text, fmt::format("{} {}", name, describe(range)));
  return *value;
}

std::uint64_t parseWhole(const std::string& where, std::string_view text, std::uint64_t min, std::uint64_t max) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (!whole || value < min || value > max) refuse(where, text, fmt::format("whole numbers from {} to {}", min, max));
  return value;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t at = text.find(separator);
    parts.emplace_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

glm::dvec3 parseVector(const std::string& where, std::string_view text, const Range& range) {
  const std::vector<std::string> parts = split(text, ',');
  const std::string name = "three numbers with commas, each";
  if (parts.size() != 3) refuse(where, text, name + " " + describe(range));
  glm::dvec3 vector{};
  for (int i = 0; i < 3; ++i) vector[i] = parsePart(where, text, parts[static_cast<std::size_t>(i)], name, range);
  return vector;
}

Field numberField(std::string name, std::string value, std::string help, const Range& range, double& target,
                  double scale) {
  return {std::move(name), std::move(value), std::move(help) + ", " + describe(range),
          [range, &target, scale](const std::string& where, const std::vector<std::string>& texts) {
            target = parseNumber(where, texts.front(), range) * scale;
          }};
}

Field wholeField(std::string name, std::string value, std::string help, std::uint64_t min, std::uint64_t max,
                 std::function<void(std::uint64_t)> set) {
  return {std::move(name), std::move(value), fmt::format("{}, {} to {}", help, min, max),
          [min, max, set = std::move(set)](const std::string& where, const std::vector<std::string>& texts) {
            set(parseWhole(where, texts.front(), min, max));
          }};
}

Field vectorField(std::string name, std::string help, const Range& range, std::function<void(const glm::dvec3&)> set) {
  return {std::move(name), "X,Y,Z", std::move(help) + ", each " + describe(range),
          [range, set = std::move(set)](const std::string& where, const std::vector<std::string>& texts) {
            set(parseVector(where, texts.front(), range));
          }};
}

Fields operator+(Fields first, Fields second) {
  first.insert(first.end(), std::make_move_iterator(second.begin()), std::make_move_iterator(second.end()));
  return first;
}

}  // namespace common
