/// The camera as a user places it.
#pragma once

#include <vulkan/vulkan_core.h>

#include <pelagic/camera.hpp>

#include "field.hpp"

namespace common {

struct View {
  glm::dvec3 position{0, 3, 0};  ///< [m]
  glm::dvec3 lookAt{100, 2, 0};  ///< [m]
  double fov = 45;               ///< Full vertical angle [degrees].
};

/// Distance of the near plane that cameraOf() sets [m].
inline constexpr float kNearPlane = 0.1f;

/// Setters of `view`, which must outlive them.
Fields viewFields(View& view);
/// WxH in pixels, each 1 to 16384.
Field extentField(std::string name, const std::string& help, VkExtent2D& extent);
/// Reversed infinite depth, y down as Vulkan has it. Looking straight up or down, the top of the picture is toward -z.
/// Throws a Failure when the camera looks at its own place.
pelagic::Camera cameraOf(const View& view, double aspect);
/// Reversed infinite depth, y down: `fov` is the full vertical angle [rad].
glm::mat4 projection(double fov, double aspect);
/// World to view directions of an eye that looks along `forward`, not zero, and holds its head up.
glm::mat3 rotationToward(const glm::dvec3& forward);

}  // namespace common
