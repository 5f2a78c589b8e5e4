#include <gpu/field.hpp>
#include <pelagic/composite.hpp>

namespace pelagic {

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
    PELAGIC_CHECK(gpu::check("HostLight " + std::to_string(i) + "'s ",
                             {{"position.x", light.position.x, -1e9, 1e9, "-1e9 to 1e9 m"},
                              {"position.y", light.position.y, 0, 1e5, "0 to 1e5 m"},
                              {"position.z", light.position.z, -1e9, 1e9, "-1e9 to 1e9 m"},
                              {"radius", light.radius, 1e-3, 1e4, "1e-3 to 1e4 m"},
                              intensity("intensity.r", 0),
                              intensity("intensity.g", 1),
                              intensity("intensity.b", 2)}));
  }
  return {};
}

}  // namespace pelagic
