/// Where the grid of the surface lies: the CPU's part of a frame, in double precision.
#pragma once

#include <vulkan/vulkan_core.h>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <pelagic/camera.hpp>
#include <span>

namespace pelagic::surface {

/// How far the water may be from its undisplaced place, and what that is a sphere of [m].
struct Relief {
  double deviation = 0;   ///< Standard deviation of the elevation.
  double vertical = 0;    ///< Bound of |elevation|.
  double horizontal = 0;  ///< Bound of the horizontal displacement.
  double planetRadius = kEarthRadius;
};

/// What the buffers of a view hold.
struct GridLimits {
  std::uint32_t blocks = 0;
  std::uint32_t rows = 0;
};
/// Room for many times the blocks that cover the picture: water that may be displaced into it, pictures that lie
/// diagonally in the grid, rows closer than asked for where waves are large. A grid that needs more has larger cells.
GridLimits limitsOf(VkExtent2D extent, double targetEdge) noexcept;

/// The projected grid. It is uniform in the picture of a camera with the host camera's axis but no roll; see
/// shaders/surface/surface_frame.h for how its numbers make a point.
struct Grid {
  glm::dvec2 right{1, 0};     ///< World (x,z) of X.
  glm::dvec2 forward{0, -1};  ///< World (x,z) of Z.
  double firstColumn = 0;
  double columnStep = 0;
  double edge = 0;                 ///< Of the cells [px].
  double radius = 0;               ///< Nothing beyond this distance from the camera's foot can be seen [m].
  std::uint32_t columnBlocks = 0;  ///< 0 when no water can be in the picture.
  std::uint32_t rowBlocks = 0;
};

/// Lays the grid out for cells of `targetEdge` [px], or larger ones where `limits` demand it, and fills
/// rowBlocks * kBlockCells + 1 entries of `rows`: Z and the width W [m], near to far.
/// Every point of the sea that can be displaced into the picture lies within the grid.
Grid projectGrid(const Camera& camera, VkExtent2D extent, double targetEdge, const Relief& relief,
                 const GridLimits& limits, std::span<glm::vec2> rows) noexcept;

/// Horizontal distance from the foot of an eye at `height` >= 0 [m] to its horizon [m].
double horizonDistance(double height, double planetRadius) noexcept;
/// How far sea level lies below the tangent plane at a horizontal distance [m].
double curvatureDrop(double distance, double planetRadius) noexcept;

}  // namespace pelagic::surface
