#include "points_file.hpp"

#include <fmt/format.h>

#include <common/field.hpp>
#include <common/settings_file.hpp>
#include <sstream>

namespace query {

std::vector<glm::dvec2> readPoints(const std::string& where, const std::string& path) {
  std::vector<glm::dvec2> points;
  std::istringstream lines(common::readTextFile(where, path));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    const std::string place = fmt::format("{} {}:{}", where, path, number);
    std::vector<std::string> cells = common::split(line, ',');
    if (cells.size() != 2) common::refuse(place, line, "x,z: two numbers with a comma between");
    if (points.size() == kMostPoints) common::refuse(place, line, fmt::format("{} points at most", kMostPoints));
    glm::dvec2 point(0);
    for (int i = 0; i < 2; ++i) {
      std::string& cell = cells[static_cast<std::size_t>(i)];
      cell.erase(0, cell.find_first_not_of(' '));
      cell.erase(cell.find_last_not_of(' ') + 1);
      point[i] = common::parsePart(place, line, cell, i == 0 ? "an x of" : "a z of", {-1e9, 1e9, "m"});
    }
    points.push_back(point);
  }
  if (points.empty()) common::refuse(where, path, "a file with at least one line x,z");
  return points;
}

}  // namespace query
