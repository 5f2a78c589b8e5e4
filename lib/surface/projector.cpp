#include <surface/surface_frame.h>
#include <algorithm>
#include <cmath>
#include <surface/projector.hpp>
#include <surface/rows.hpp>

namespace pelagic::surface {
namespace {

using shader::kBlockCells;

/// The picture as a pyramid of directions around the eye, and the frame of the heading.
struct Frustum {
  std::array<glm::dvec3, 4> corners;  ///< World directions in order around the picture, depth 1.
  glm::dvec3 axis;
  glm::dvec2 right;
  glm::dvec2 forward;
  glm::dvec2 pixels;  ///< Pixels per unit of the picture at depth 1, along `right` and upward.
};

/// A point relative to the camera's foot in the frame of the heading: (X, height, Z).
glm::dvec3 toHeading(const Frustum& frustum, const glm::dvec3& world) {
  const glm::dvec2 ground(world.x, world.z);
  return {glm::dot(ground, frustum.right), world.y, glm::dot(ground, frustum.forward)};
}

Frustum frustumOf(const Camera& camera, VkExtent2D extent) {
  Frustum result;
  const glm::dmat3 toWorld = glm::transpose(glm::dmat3(camera.rotation));
  const glm::dmat4 projection(camera.projection);
  const glm::dmat4 inverse = glm::inverse(projection);
  const glm::dmat4 rows = glm::transpose(projection);
  const glm::dvec3 depth(rows[3]);  // clip w as a function of the view position
  result.axis = glm::normalize(toWorld * depth);

  const double level = std::hypot(result.axis.x, result.axis.z);
  const glm::dvec3 up = toWorld * glm::dvec3(rows[1]);
  // Looking straight down or up any heading will do.
  result.forward =
      level > 1e-6 ? glm::dvec2(result.axis.x, result.axis.z) / level : glm::normalize(glm::dvec2(up.x, up.z));
  result.right = {-result.forward.y, result.forward.x};

  constexpr std::array<glm::dvec2, 4> kNdc{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    // Any depth within the picture gives the ray; the sign of w cancels.
    const glm::dvec3 view(inverse * glm::dvec4(kNdc[i], 0.5, 1));
    const glm::dvec3 world = toWorld * view;
    const double along = glm::dot(world, result.axis);
    result.corners[i] = toHeading(result, world / along);
  }
  const glm::dvec3 e1(result.right.x, 0, result.right.y);
  const glm::dvec3 e2 = glm::cross(e1, result.axis);
  const auto pixelsAlong = [&](const glm::dvec3& direction) {
    const glm::dvec3 view = glm::dmat3(camera.rotation) * direction;
    const double scale = 0.5 / glm::length(depth);
    return std::hypot(scale * extent.width * glm::dot(glm::dvec3(rows[0]), view),
                      scale * extent.height * glm::dot(glm::dvec3(rows[1]), view));
  };
  result.pixels = {pixelsAlong(e1), pixelsAlong(e2)};
  return result;
}

/// Points whose convex hull is the part of the picture's pyramid in which water within `distance` of the foot can be.
struct Hull {
  std::array<glm::dvec2, 32> points;  ///< (X, Z)
  std::size_t count = 0;
  void add(const glm::dvec3& p) { points[count++] = {p.x, p.z}; }
};

Hull waterHull(const Frustum& frustum, double height, const Relief& relief, double distance) {
  const double top = relief.vertical;
  const double bottom = -curvatureDrop(distance, relief.planetRadius) - relief.vertical;
  const double far = 1.05 * std::hypot(distance, std::abs(height) + std::max(top, -bottom));
  const glm::dvec3 eye(0, height, 0);
  std::array<glm::dvec3, 4> ends;
  for (std::size_t i = 0; i < 4; ++i) ends[i] = eye + far * frustum.corners[i];

  Hull hull;
  const auto vertex = [&](const glm::dvec3& p) {
    if (p.y >= bottom && p.y <= top) hull.add(p);
  };
  const auto edge = [&](const glm::dvec3& a, const glm::dvec3& b) {
    for (const double level : {bottom, top}) {
      if ((a.y < level) != (b.y < level)) hull.add(glm::mix(a, b, (level - a.y) / (b.y - a.y)));
    }
  };
  vertex(eye);
  for (std::size_t i = 0; i < 4; ++i) {
    vertex(ends[i]);
    edge(eye, ends[i]);
    edge(ends[i], ends[(i + 1) % 4]);
  }
  return hull;
}

/// The hull for the least distance that holds all of it.
Hull tightHull(const Frustum& frustum, double height, const Relief& relief, double radius) {
  Hull hull = waterHull(frustum, height, relief, radius);
  for (int i = 0; i < 3; ++i) {
    double reach = 0;
    for (std::size_t p = 0; p < hull.count; ++p) reach = std::max(reach, glm::length(hull.points[p]));
    if (hull.count == 0 || reach >= radius) break;
    radius = reach;
    hull = waterHull(frustum, height, relief, radius);
  }
  return hull;
}

struct Range {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// Range of X / W over the hull, widened by `margin` in every direction. W is piecewise linear, so its extremes lie at
/// the corners and where an edge crosses a bend of W.
Range columnRange(const Hull& hull, const RowDensity& rows, double margin) {
  std::array<glm::dvec2, 4 * 32> points;
  std::size_t count = 0;
  Range range;
  for (std::size_t i = 0; i < hull.count; ++i) {
    for (const glm::dvec2 corner : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
      const glm::dvec2 p = hull.points[i] + margin * corner;
      range.add(p.x / rows.width(p.y));
      points[count++] = p;
    }
  }
  for (const double bend : rows.bends()) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) {
        const glm::dvec2 a = points[i];
        const glm::dvec2 b = points[j];
        if (a.y < bend && b.y > bend) range.add(glm::mix(a.x, b.x, (bend - a.y) / (b.y - a.y)) / rows.width(bend));
      }
    }
  }
  // Between two rows the sides are chords of W.
  range.low -= rows.step;
  range.high += rows.step;
  return range;
}

/// The density of the rows for cells of `edge` pixels, `coarseness` times what was asked for.
RowDensity densityOf(const Frustum& frustum, double height, const Relief& relief, double edge, double coarseness) {
  // A camera among the crests sees them as if it stood about one deviation above the water, one far below mirrored.
  const bool below = height < -3 * relief.deviation;
  const double side = below ? -1 : 1;
  Range slopes;  // of the picture's directions toward the water
  for (const glm::dvec3& corner : frustum.corners) slopes.add(-side * corner.y);
  RowDensity rows;
  rows.step = edge / frustum.pixels.y;
  rows.height = std::max(std::hypot(height, relief.deviation), 0.05);
  rows.slope = std::hypot(frustum.axis.x, frustum.axis.z);
  rows.offset = -side * frustum.axis.y * rows.height;
  rows.floor = rows.height / std::max(slopes.high, (slopes.high - slopes.low) / 4);
  rows.reach = relief.deviation * frustum.pixels.y;
  constexpr double kChordError = 0.05;  // [px]
  rows.curvature = std::sqrt(frustum.pixels.y / (8 * relief.planetRadius * kChordError)) / coarseness;
  return rows;
}

}  // namespace

double horizonDistance(double height, double planetRadius) noexcept {
  return std::sqrt(height * (2 * planetRadius + height)) * planetRadius / (planetRadius + height);
}

double curvatureDrop(double distance, double planetRadius) noexcept {
  const double r2 = distance * distance;
  return r2 / (planetRadius + std::sqrt(std::max(planetRadius * planetRadius - r2, 0.0)));
}

GridLimits limitsOf(VkExtent2D extent, double targetEdge) noexcept {
  const double block = targetEdge * kBlockCells;
  const double across = std::ceil(extent.width / block) + 2;
  const double down = std::ceil(extent.height / block) + 2;
  GridLimits limits;
  limits.blocks = static_cast<std::uint32_t>(10 * across * down);
  limits.rows = static_cast<std::uint32_t>((10 * std::max(across, down) + 16) * kBlockCells) + 1;
  return limits;
}

Grid projectGrid(const Camera& camera, VkExtent2D extent, double targetEdge, const Relief& relief,
                 const GridLimits& limits, std::span<glm::vec2> rows) noexcept {
  const double height = camera.position.y;
  const Frustum frustum = frustumOf(camera, extent);
  Grid grid;
  grid.edge = targetEdge;
  grid.right = frustum.right;
  grid.forward = frustum.forward;
  grid.radius = horizonDistance(std::max(std::abs(height), 0.05), relief.planetRadius) +
                horizonDistance(relief.vertical, relief.planetRadius);

  const Hull hull = tightHull(frustum, height, relief, grid.radius);
  Range z;
  for (std::size_t i = 0; i < hull.count; ++i) z.add(hull.points[i].y);
  const double near = std::max(z.low - relief.horizontal, -grid.radius);
  const double far = std::min(z.high + relief.horizontal, grid.radius);
  if (!(near < far)) return grid;  // also when the camera is not finite

  for (double edge = targetEdge;; edge *= 1.1) {
    const RowDensity density = densityOf(frustum, height, relief, edge, edge / targetEdge);
    const Range columns = columnRange(hull, density, relief.horizontal);
    grid.columnStep = edge / frustum.pixels.x;
    grid.edge = edge;
    const double columnBlocks = std::ceil((columns.high - columns.low) / (grid.columnStep * kBlockCells));
    const double rowBlocks = std::ceil(density.count(near, far) / kBlockCells);
    if (!std::isfinite(columnBlocks * rowBlocks)) return grid;
    if (columnBlocks * rowBlocks > limits.blocks || rowBlocks * kBlockCells + 1 > limits.rows) continue;

    grid.columnBlocks = static_cast<std::uint32_t>(std::max(columnBlocks, 1.0));
    grid.rowBlocks = static_cast<std::uint32_t>(std::max(rowBlocks, 1.0));
    grid.firstColumn = (columns.low + columns.high - grid.columnBlocks * kBlockCells * grid.columnStep) / 2;
    double at = far;
    for (std::uint32_t row = grid.rowBlocks * kBlockCells;; --row) {
      rows[row] = {at, density.width(at)};
      if (row == 0) return grid;
      at = density.before(at);
    }
  }
}

}  // namespace pelagic::surface
