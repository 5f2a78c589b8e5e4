#include <gtest/gtest.h>
#include <surface/surface_frame.h>
#include <surface/projector.hpp>
#include <surface/rows.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
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
    return {ground.x, -curvatureDrop(glm::length(ground)) - camera.position.y, ground.y};
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
  // From 3 m the horizon is 6.18 km away, from 3 km 196 km along the ground.
  EXPECT_NEAR(horizonDistance(3), 6183, 1);
  EXPECT_NEAR(horizonDistance(3000), 195.4e3, 0.1e3);
  EXPECT_NEAR(curvatureDrop(6183), 3, 1e-3);
  // The far circle touches the line of sight: height over distance is the slope of the sphere there.
  const double d = horizonDistance(20e3);
  EXPECT_NEAR((20e3 + curvatureDrop(d)) / d, d / (pelagic::kEarthRadius - curvatureDrop(d)), 1e-9);
}

TEST(Projector, EdgesHaveTheTargetLength) {
  struct View {
    double height, pitch, roll, fov;
  };
  for (const View& view : {View{3, 0, 0, 60}, View{3, -0.3, 0.2, 60}, View{0.5, -0.1, 0, 40}, View{30, -0.8, 1, 50},
                           View{2000, -0.4, 0, 60}, View{5, -1.57, 0, 60}, View{10, -0.2, 0, 5}}) {
    const Camera camera = cameraAt(view.height, 0.7, view.pitch, view.roll, view.fov * kDegree);
    const Laid laid = lay(camera, 8, {});
    const auto lengths = [&](std::uint32_t columns, std::uint32_t rows) {
      std::vector<double> edges;
      for (std::uint32_t row = 0; row + rows <= laid.lastRow(); ++row) {
        for (std::uint32_t column = 0; column + columns <= laid.lastColumn(); ++column) {
          glm::dvec2 a, b;
          if (pixel(camera, laid.vertex(camera, column, row), a) &&
              pixel(camera, laid.vertex(camera, column + columns, row + rows), b)) {
            edges.push_back(glm::length(a - b));
          }
        }
      }
      std::sort(edges.begin(), edges.end());
      return edges;
    };
    for (const bool along : {false, true}) {
      const std::vector<double> edges = along ? lengths(0, 1) : lengths(1, 0);
      ASSERT_GT(edges.size(), 1000u);
      EXPECT_NEAR(edges[edges.size() / 2], 8, 0.3 * 8) << view.height << " m, pitch " << view.pitch;
      EXPECT_LE(edges[edges.size() * 95 / 100], 16) << view.height << " m, pitch " << view.pitch;
    }
  }
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

TEST(Projector, KeepsToTheLimits) {
  const GridLimits limits{400, 2000};
  for (const double fov : {2.0, 20.0, 60.0, 120.0}) {
    for (const double deviation : {0.0, 0.4, 2.0, 5.0}) {
      for (const double height : {-1.0, 0.3, 3.0, 500.0}) {
        const Relief relief{deviation, 6 * deviation, 6 * deviation};
        const Laid laid = lay(cameraAt(height, 0, -0.01, 0.3, fov * kDegree), 8, relief, limits);
        EXPECT_LE(laid.grid.columnBlocks * laid.grid.rowBlocks, limits.blocks);
        EXPECT_LT(laid.lastRow(), limits.rows);
        EXPECT_GT(laid.grid.columnBlocks, 0u);
        for (std::uint32_t row = 1; row <= laid.lastRow(); ++row) ASSERT_GT(laid.rows[row].x, laid.rows[row - 1].x);
      }
    }
  }
}

TEST(Projector, SkyAloneHasNoGrid) {
  EXPECT_EQ(lay(cameraAt(10, 0, 1, 0, 1), 8, {0.1, 0.6, 0.6}).grid.columnBlocks, 0u);
  EXPECT_EQ(lay(cameraAt(std::nan(""), 0, -1, 0, 1), 8, {}).grid.columnBlocks, 0u);
}

}  // namespace
