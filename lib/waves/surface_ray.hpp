/// What CPU and GPU have in common about the places that a sea is asked for.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <optional>

namespace pelagic {

/// Farther from the origin [m] a point is not where it was asked for.
inline constexpr double kFarthest = 1e9;

/// false for what is not finite.
inline bool onEarth(const glm::dvec2& point) noexcept {
  return std::abs(point.x) <= kFarthest && std::abs(point.y) <= kFarthest;
}

/// The part of a ray where it can meet the sea, by its distance from the origin [m].
struct RayPart {
  glm::dvec3 direction;  ///< Unit.
  double from, to;
};

/// None for a ray that cannot meet a sea whose elevation has the standard deviation `deviation` [m], or is none.
inline std::optional<RayPart> partAtSea(const glm::dvec3& origin, const glm::dvec3& direction, double reach,
                                        double deviation) noexcept {
  const double length = glm::length(direction);
  if (!(length > 0 && std::isfinite(length) && reach >= 0 && std::isfinite(origin.y))) return {};
  RayPart part{direction / length, 0, std::min(reach, 2 * kFarthest)};
  const double rise = part.direction.y;
  // No crest stands beyond `top`: outside the layer between -top and top there is nothing to meet.
  const double top = 6 * deviation + 1e-3;
  if (std::abs(origin.y) > top) {
    if (origin.y * rise >= 0) return {};
    part.from = (std::abs(origin.y) - top) / std::abs(rise);
  }
  if (rise != 0) part.to = std::min(part.to, ((rise > 0 ? top : -top) - origin.y) / rise);
  const glm::dvec3 start = origin + part.from * part.direction;
  if (!(part.from <= part.to && onEarth({start.x, start.z}))) return {};
  return part;
}

}  // namespace pelagic
