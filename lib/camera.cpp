#include <pelagic/camera.hpp>

namespace pelagic {

/// Linear in the pixel, since a perspective projection puts only a multiple of the view's z into w.
PixelRays pixelRays(const Camera& camera, VkExtent2D extent) noexcept {
  const glm::dmat4 unproject = glm::inverse(glm::dmat4(camera.projection));
  const glm::dmat3 toWorld = glm::transpose(glm::dmat3(camera.rotation));
  const auto ray = [&](double x, double y) {
    const glm::dvec4 clip(2 * (x + 0.5) / extent.width - 1, 2 * (y + 0.5) / extent.height - 1, 1, 1);
    return toWorld * glm::dvec3(unproject * clip);
  };
  const glm::dvec3 origin = ray(0, 0);
  return {origin, ray(1, 0) - origin, ray(0, 1) - origin};
}

}  // namespace pelagic
