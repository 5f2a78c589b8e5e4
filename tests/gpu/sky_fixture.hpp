/// Skies, their views and their maps read back.
#pragma once

#include <cmath>
#include <cstring>
#include <numbers>
#include <pelagic/sky.hpp>
#include <stdexcept>

#include "pelagic/shader/sky_light.h"
#include "support/gpu_test.hpp"

namespace support {

struct SkyMap {
  std::vector<float> texels;
  int width = 0, height = 0;
  glm::dvec3 at(int x, int y) const {
    const float* p = &texels[4 * static_cast<std::size_t>(y * width + x)];
    return {p[0], p[1], p[2]};
  }
  double alpha(int x, int y) const { return texels[4 * static_cast<std::size_t>(y * width + x) + 3]; }
  /// Of the radiance map, bilinear; rows counted from the horizon.
  glm::dvec3 toward(double azimuth, double elevation) const {
    const double x = azimuth / (2 * std::numbers::pi) * width - 0.5;
    const double y = (0.5 + 0.5 * std::sqrt(elevation / (std::numbers::pi / 2))) * height - 0.5;
    const double left = std::floor(x), low = std::floor(y);
    const auto texel = [&](double dx, double dy) {
      const double u = left + dx - std::floor((left + dx) / width) * width;
      return at(static_cast<int>(u), static_cast<int>(std::min(low + dy, height - 1.0)));
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), x - left), glm::mix(texel(0, 1), texel(1, 1), x - left),
                    y - low);
  }
};

class SkyFixture : public GpuTest {
 protected:
  pelagic::Sky createSky(const pelagic::SkyState& state, double planetRadius = pelagic::kEarthRadius,
                         const pelagic::SkyEnvironment& environment = {}) {
    auto sky = pelagic::Sky::create(device(), state, planetRadius, environment);
    if (!sky) throw std::runtime_error(sky.error().message);
    return std::move(*sky);
  }
  pelagic::SkyView createView(const pelagic::Sky& sky, VkExtent2D extent = {64, 64}) {
    auto view = pelagic::SkyView::create(sky, extent);
    if (!view) throw std::runtime_error(view.error().message);
    return std::move(*view);
  }
  static pelagic::Camera cameraAt(double altitude) {
    pelagic::Camera camera;
    camera.position = {0, altitude, 0};
    camera.projection = glm::mat4(1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, -1, 0, 0, 0.1f, 0);
    return camera;
  }
  SkyMap read(const pelagic::MapView& map, std::uint32_t mip = 0) {
    return {common::readFloats(gpu(), map, mip), static_cast<int>(map.extent.width >> mip),
            static_cast<int>(map.extent.height >> mip)};
  }
  pelagic::shader::SkyLight light(const pelagic::SkyMaps& maps) {
    pelagic::shader::SkyLight block;
    const auto bytes = common::readBuffer(gpu(), maps.light, maps.lightSize);
    std::memcpy(&block, bytes.data(), sizeof(block));
    return block;
  }
};

}  // namespace support
