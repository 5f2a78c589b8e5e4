/// The file of points.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace query {

/// Most points of a file: what one call of PointQuery takes.
inline constexpr std::size_t kMostPoints = 1000000;

/// Rows `x,z` [m]. Empty lines and lines that start with # are skipped. Throws a Failure that names file, line and
/// value.
std::vector<glm::dvec2> readPoints(const std::string& where, const std::string& path);

}  // namespace query
