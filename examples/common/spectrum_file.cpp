#include "spectrum_file.hpp"

#include <fmt/format.h>

#include <glm/gtc/constants.hpp>
#include <sstream>

#include "failure.hpp"
#include "field.hpp"
#include "settings_file.hpp"

namespace common {
namespace {

const double kDegree = glm::pi<double>() / 180;  // [rad]

void readDirections(const std::string& place, const std::vector<std::string>& cells, pelagic::SpectrumTable& table) {
  for (std::size_t i = 1; i < cells.size(); ++i) {
    table.direction.push_back(parseNumber(place, cells[i], {-360, 360, "degrees"}) * kDegree);
  }
}

void readRow(const std::string& place, const std::string& line, const std::vector<std::string>& cells,
             pelagic::SpectrumTable& table) {
  const std::size_t values = std::max<std::size_t>(1, table.direction.size());
  if (cells.size() != values + 1) refuse(place, line, fmt::format("{} numbers with commas", values + 1));
  table.frequency.push_back(parseNumber(place, cells[0], {1e-3, 50, "Hz"}));
  for (std::size_t i = 1; i <= values; ++i) {
    const std::string_view unit = table.direction.empty() ? "m^2/Hz" : "m^2/(Hz rad)";
    table.density.push_back(parseNumber(place, cells[i], {0, 1e6, unit}));
  }
}

}  // namespace

pelagic::SpectrumTable readSpectrum(const std::string& where, const std::string& path) {
  pelagic::SpectrumTable table;
  std::istringstream lines(readTextFile(where, path));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    const std::string place = fmt::format("{} {}:{}", where, path, number);
    std::vector<std::string> cells = split(line, ',');
    for (std::string& cell : cells) {
      cell.erase(0, cell.find_first_not_of(' '));
      cell.erase(cell.find_last_not_of(' ') + 1);
    }
    if (cells.front() == "f" && table.frequency.empty() && table.direction.empty()) {
      readDirections(place, cells, table);
    } else {
      readRow(place, line, cells, table);
    }
  }
  if (table.frequency.size() < 2) refuse(where, path, "a file with at least two rows of frequency and density");
  return table;
}

}  // namespace common
