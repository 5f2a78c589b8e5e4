#include <gtest/gtest.h>
#include <surface/surface_frame.h>
#include <surface/projector.hpp>
#include <surface/rows.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

namespace {

using pelagic::Camera;
using pelagic::shader::kBlockCells;
using namespace pelagic::surface;

constexpr double kDegree = std::numbers::pi / 180;
constexpr VkExtent2D kExtent{1280, 720};
constexpr GridLimits kPlenty{1u << 24, 1u << 20};

/// Reversed infinite depth, y down; yaw from -z toward +x.
Camera cameraAt(double height, double yaw, double pitch, double roll, double fov) {
  const glm::dvec3 forward(std::cos(pitch) * std::sin(yaw), std::sin(pitch), -std::cos(pitch) * std::cos(yaw));
  const glm::dvec3 level(std::cos(yaw), 0, std::sin(yaw));
  const glm::dvec3 right = std::cos(roll) * level + std::sin(roll) * glm::cross(level, forward);
  Camera camera;
  camera.position = {0, height, 0};
  camera.rotation = glm::mat3(glm::transpose(glm::dmat3(right, glm::cross(right, forward), -forward)));
  const double focal = 1 / std::tan(fov / 2);
  camera.projection = glm::mat4(0);
  camera.projection[0][0] = static_cast<float>(focal * kExtent.height / kExtent.width);
  camera.projection[1][1] = static_cast<float>(-focal);
  camera.projection[2][3] = -1;
  camera.projection[3][2] = 0.1f;
  return camera;
}

/// Picture coordinates [px] of a point relative to the camera; false behind it or outside.
bool pixel(const Camera& camera, const glm::dvec3& relative, glm::dvec2& result) {
  const glm::dvec4 clip = glm::dmat4(camera.projection) * glm::dvec4(glm::dmat3(camera.rotation) * relative, 1);
  const glm::dvec2 size(kExtent.width, kExtent.height);
  result = (0.5 * glm::dvec2(clip) / clip.w + 0.5) * size;
  return clip.w > 0 && glm::all(glm::greaterThan(result, glm::dvec2(0))) && glm::all(glm::lessThan(result, size));
}

struct Laid {
  Grid grid;
  std::vector<glm::vec2> rows;
  std::uint32_t lastRow() const { return grid.rowBlocks * kBlockCells; }
  std::uint32_t lastColumn() const { return grid.columnBlocks * kBlockCells; }
  /// (X, Z) of a vertex.
  glm::dvec2 local(std::uint32_t column, std::uint32_t row) const {
    const glm::dvec2 r(rows[row]);
    const glm::dvec2 p((grid.firstColumn + column * grid.columnStep) * r.y, r.x);
    const double range = glm::length(p);
    return range > grid.radius ? p * (grid.radius / range) : p;
  }
  /// Undisplaced vertex relative to the camera.
  glm::dvec3 vertex(const Camera& camera, std::uint32_t column, std::uint32_t row) const {
    const glm::dvec2 p = local(column, row);
    const glm::dvec2 ground = p.x * grid.right + p.y * grid.forward;
    return {ground.x, -curvatureDrop(glm::length(ground), pelagic::kEarthRadius) - camera.position.y, ground.y};
  }
};

Laid lay(const Camera& camera, double edge, const Relief& relief, const GridLimits& limits = kPlenty) {
  Laid laid;
  laid.rows.resize(1u << 20);
  laid.grid = projectGrid(camera, kExtent, edge, relief, limits, laid.rows);
  return laid;
}

TEST(RowDensity, CountIsTheIntegral) {
  const RowDensity rows{0.0128, 0.9, 1.3, 5, 3.1, 225, 0.01};
  for (const auto& [from, to] :
       {std::pair(-9.0, -4.0), std::pair(-9.0, 300.0), std::pair(4.0, 5.0), std::pair(100.0, 9e3)}) {
    // Midpoint rule in the logarithm of the distance from a point before all.
    double sum = 0;
    constexpr int kSteps = 400000;
    const double a = std::log(from + 10), b = std::log(to + 10);
    for (int i = 0; i < kSteps; ++i) {
      const double x = std::exp(a + (b - a) * (i + 0.5) / kSteps);
      sum += rows.density(x - 10) * x * (b - a) / kSteps;
    }
    EXPECT_NEAR(rows.count(from, to), sum, 1e-5 * sum) << from << " … " << to;
  }
}

TEST(RowDensity, RowsAreOneApart) {
  for (const RowDensity& rows : {RowDensity{0.0128, 0.9, 1.3, 5, 3.1, 225, 0.01}, RowDensity{0.1, 0, 3, 2, 3, 0, 0.001},
                                 RowDensity{0.0004, 1, 0, 170, 3, 36e3, 0.05}}) {
    double z = 6000;
    for (int i = 0; i < 200; ++i) {
      const double next = rows.before(z);
      ASSERT_LT(next, z);
      ASSERT_NEAR(rows.count(next, z), 1, 1e-6) << "row " << i << " at " << z;
      z = next;
    }
  }
}

TEST(Projector, HorizonAndCurvature) {
  constexpr double kEarth = pelagic::kEarthRadius;
  // From 3 m the horizon is 6.18 km away, from 3 km 196 km along the ground.
  EXPECT_NEAR(horizonDistance(3, kEarth), 6183, 1);
  EXPECT_NEAR(horizonDistance(3000, kEarth), 195.4e3, 0.1e3);
  EXPECT_NEAR(curvatureDrop(6183, kEarth), 3, 1e-3);
  // The far circle touches the line of sight: height over distance is the slope of the sphere there.
  for (const double radius : {1e5, kEarth, 1e8}) {
    const double d = horizonDistance(20e3, radius);
    const double drop = curvatureDrop(d, radius);
    EXPECT_NEAR((20e3 + drop) / d, d / (radius - drop), 1e-9);
  }
}

/// Lengths on the screen of the edges of all triangles of the undisplaced sea, where both ends are seen, in order [px].
std::vector<double> edgesOnScreen(const Camera& camera, const Laid& laid) {
  const std::uint32_t columns = laid.lastColumn() + 1;
  std::vector<std::optional<glm::dvec2>> pixels(std::size_t{columns} * (laid.lastRow() + 1));
  for (std::uint32_t i = 0; i < pixels.size(); ++i) {
    const glm::dvec3 vertex = laid.vertex(camera, i % columns, i / columns);
    glm::dvec2 at;
    // Beyond the horizon cells are drawn in to nothing.
    const bool hidden = std::hypot(vertex.x, vertex.z) > 0.999 * laid.grid.radius;
    if (!hidden && pixel(camera, vertex, at)) pixels[i] = at;
  }
  std::vector<double> edges;
  const auto add = [&](std::size_t a, std::size_t b) {
    if (pixels[a] && pixels[b]) edges.push_back(glm::length(*pixels[a] - *pixels[b]));
  };
  for (std::uint32_t row = 0; row <= laid.lastRow(); ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::size_t i = std::size_t{row} * columns + column;
      if (column + 1 < columns) add(i, i + 1);
      if (row < laid.lastRow()) add(i, i + columns);
      if (column + 1 < columns && row < laid.lastRow()) add(i + 1, i + columns);
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

TEST(Projector, EdgesHaveTheTargetLength) {
  std::mt19937 random(11);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  constexpr double kEdge = 12;
  int measured = 0;
  for (int n = 0; n < 220; ++n) {
    const bool below = n % 11 == 0;
    const double height = below ? between(-50, -1) : 0.3 * std::pow(20e3 / 0.3, between(0, 1));
    const double pitch = n % 8 == 0 ? (below ? 90 : -90) : (below ? between(-20, 90) : between(-90, 20));
    const double roll = n % 2 == 0 ? between(-180, 180) : 0;
    const double fov = 2 * std::pow(60.0, between(0, 1));
    Camera camera = cameraAt(height, between(-3, 3), pitch * kDegree, roll * kDegree, fov * kDegree);
    if (n % 4 == 1) camera.projection[2] = glm::vec4(between(-0.8, 0.8), between(-0.8, 0.8), 0, -1);
    const std::vector<double> edges = edgesOnScreen(camera, lay(camera, kEdge, {}, limitsOf(kExtent, kEdge)));
    if (edges.size() < 300) continue;  // sky
    ++measured;
    EXPECT_NEAR(edges[edges.size() / 2], kEdge, 0.3 * kEdge) << "camera " << n << ", " << height << " m";
    EXPECT_LE(edges[edges.size() * 95 / 100], 2 * kEdge) << "camera " << n << ", " << height << " m";
  }
  EXPECT_GE(measured, 190);
}

TEST(Projector, HoldsAllWaterThatCanBeDisplacedIntoThePicture) {
  std::mt19937 random(3);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int seen = 0;
  for (int n = 0; n < 400; ++n) {
    const double height = n % 3 == 0 ? between(-5, 5) : std::pow(10.0, between(-0.5, 3));
    const double pitch = between(-90, 20), roll = between(-180, 180), fov = 2 * std::pow(60.0, between(0, 1));
    const Camera camera = cameraAt(height, between(-3, 3), pitch * kDegree, roll * kDegree, fov * kDegree);
    const Relief relief{0.5, 3, 4};
    const Laid laid = lay(camera, 8, relief);
    for (int i = 0; i < 500; ++i) {
      // A point in the picture at some depth, when it lies in the layer of the waves.
      const glm::dvec2 ndc(between(-1, 1), between(-1, 1));
      const glm::dvec3 view(ndc.x / camera.projection[0][0], ndc.y / camera.projection[1][1], -1);
      const glm::dvec3 ray = glm::transpose(glm::dmat3(camera.rotation)) * view;
      const double level = between(-3, 3);
      if ((level - height) * ray.y <= 0) continue;
      const glm::dvec3 point = ray * ((level - height) / ray.y);
      // Its water has been moved here from as far as it can.
      const double angle = between(-std::numbers::pi, std::numbers::pi);
      const glm::dvec2 source = glm::dvec2(point.x, point.z) + 4.0 * glm::dvec2(std::cos(angle), std::sin(angle));
      if (glm::length(source) > 0.3 * laid.grid.radius) continue;
      ASSERT_GT(laid.grid.columnBlocks, 0u);
      const glm::dvec2 local(glm::dot(source, laid.grid.right), glm::dot(source, laid.grid.forward));
      ++seen;
      ASSERT_GE(local.y, static_cast<double>(laid.rows[0].x) - 1e-3) << "camera " << n;
      ASSERT_LE(local.y, static_cast<double>(laid.rows[laid.lastRow()].x) + 1e-3) << "camera " << n;
      const auto* row = std::upper_bound(laid.rows.data(), laid.rows.data() + laid.lastRow(), local.y,
                                         [](double z, const glm::vec2& r) { return z < static_cast<double>(r.x); });
      const glm::dvec2 far(*row), near(row == laid.rows.data() ? *row : row[-1]);
      const double width = near.y + (far.y - near.y) * (local.y - near.x) / std::max(far.x - near.x, 1e-9);
      ASSERT_GE(local.x, laid.grid.firstColumn * width - 1e-3) << "camera " << n;
      ASSERT_LE(local.x, (laid.grid.firstColumn + laid.lastColumn() * laid.grid.columnStep) * width + 1e-3);
    }
  }
  EXPECT_GT(seen, 20000);
}

TEST(Projector, EndsWhereTheHighestCrestSinksBelowTheHorizon) {
  for (const double radius : {1e5, pelagic::kEarthRadius}) {
    const Relief relief{1, 6, 6, radius};
    const double angle = std::acos(radius / (radius + 3)) + std::acos(radius / (radius + relief.vertical));
    EXPECT_NEAR(lay(cameraAt(3, 0, 0, 0, 1), 12, relief).grid.radius, radius * std::sin(angle), 1e-3 * radius * angle);
  }
}

TEST(Projector, KeepsToTheLimits) {
  const GridLimits limits{400, 2000};
  int enlarged = 0;
  for (const double fov : {2.0, 20.0, 60.0, 120.0}) {
    for (const double deviation : {0.0, 0.4, 2.0, 5.0}) {
      for (const double height : {-1.0, 0.3, 3.0, 500.0}) {
        const Relief relief{deviation, 6 * deviation, 6 * deviation};
        const Laid laid = lay(cameraAt(height, 0, -0.01, 0.3, fov * kDegree), 8, relief, limits);
        EXPECT_LE(laid.grid.columnBlocks * laid.grid.rowBlocks, limits.blocks);
        EXPECT_LT(laid.lastRow(), limits.rows);
        EXPECT_GT(laid.grid.columnBlocks, 0u);
        // Middle columns at the distance W are `edge` pixels apart.
        const double pixels = kExtent.height / (2 * std::tan(fov * kDegree / 2));
        EXPECT_NEAR(laid.grid.edge, laid.grid.columnStep * pixels, 1e-3 * laid.grid.edge);
        EXPECT_GE(laid.grid.edge, 8);
        enlarged += laid.grid.edge > 8;
        for (std::uint32_t row = 1; row <= laid.lastRow(); ++row) ASSERT_GT(laid.rows[row].x, laid.rows[row - 1].x);
      }
    }
  }
  EXPECT_GT(enlarged, 0);
}

TEST(Projector, SkyAloneHasNoGrid) {
  EXPECT_EQ(lay(cameraAt(10, 0, 1, 0, 1), 8, {0.1, 0.6, 0.6}).grid.columnBlocks, 0u);
  EXPECT_EQ(lay(cameraAt(std::nan(""), 0, -1, 0, 1), 8, {}).grid.columnBlocks, 0u);
}

}  // namespace
