#include <cmath>
#include <gpu/field.hpp>
#include <pelagic/composite.hpp>

namespace pelagic {
namespace {

Result<void> checkShape(const std::string& owner, const HostLight& light) {
  const double width = glm::length(light.halfWidth), height = glm::length(light.halfHeight);
  if (width == 0 && height == 0) return gpu::check(owner, {{"radius", light.radius, 1e-3, 1e4, "1e-3 to 1e4 m"}});
  const double cosine = glm::dot(light.halfWidth, light.halfHeight) / (width * height);
  const double lowest = light.position.y - std::abs(light.halfWidth.y) - std::abs(light.halfHeight.y);
  return gpu::check(owner, {{"halfWidth's length", width, 1e-3, 1e4, "1e-3 to 1e4 m"},
                            {"halfHeight's length", height, 1e-3, 1e4, "1e-3 to 1e4 m"},
                            {"cosine between halfWidth and halfHeight", cosine, -1e-3, 1e-3, "0 to within 1e-3"},
                            {"lowest corner's y", lowest, 0, 1e5, "0 to 1e5 m"}});
}

}  // namespace

Result<void> validate(std::span<const HostLight> lights) {
  if (lights.size() > kMostHostLights) {
    return gpu::reject("there are " + std::to_string(lights.size()) + " HostLights, there may be 0 to " +
                       std::to_string(kMostHostLights));
  }
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const HostLight& light = lights[i];
    const auto intensity = [&](const char* name, int channel) {
      return gpu::Field{name, light.intensity[channel], 0, 1e12, "0 to 1e12"};
    };
    const std::string owner = "HostLight " + std::to_string(i) + "'s ";
    PELAGIC_CHECK(gpu::check(owner, {{"position.x", light.position.x, -1e9, 1e9, "-1e9 to 1e9 m"},
                                     {"position.y", light.position.y, 0, 1e5, "0 to 1e5 m"},
                                     {"position.z", light.position.z, -1e9, 1e9, "-1e9 to 1e9 m"},
                                     intensity("intensity.r", 0),
                                     intensity("intensity.g", 1),
                                     intensity("intensity.b", 2)}));
    PELAGIC_CHECK(checkShape(owner, light));
  }
  return {};
}

}  // namespace pelagic
