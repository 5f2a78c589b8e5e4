/// One view of the world.
#pragma once

#include <pelagic/shader/constants.h>

#include <vulkan/vulkan_core.h>

#include <glm/glm.hpp>

namespace pelagic {

/// Mean radius of the Earth [m].
inline constexpr double kEarthRadius = shader::kEarthRadius;
/// A planet's radius may be [m].
inline constexpr double kLeastPlanetRadius = 1e5, kMostPlanetRadius = 1e8;

/// World space is right-handed, y up, metres. The still water is y = 0 below the camera and falls away with the
/// planet's curvature (SurfaceInfo::planetRadius).
struct Camera {
  glm::dvec3 position{0, 3, 0};  ///< Eye in the world [m]; |x|, |z| <= 1e9, y -1e4 … 1e5.
  glm::mat3 rotation{1};         ///< World to view directions, orthonormal.
  /// View to clip space, invertible, as the host uses it (any y direction). Perspective, off-centre allowed.
  glm::mat4 projection{1};
  bool reversedDepth = true;  ///< True: nearer is greater (preferred, with infinite far plane). False: nearer is less.
};

/// The points behind the pixels of a picture: that of clip-space w behind pixel (x, y) is w (origin + x right + y down)
/// from the eye, world axes; (0, 0) is the centre of the first pixel.
struct PixelRays {
  glm::dvec3 origin, right, down;
};
PixelRays pixelRays(const Camera& camera, VkExtent2D extent) noexcept;

}  // namespace pelagic
