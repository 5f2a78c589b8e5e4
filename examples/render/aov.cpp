#include "aov.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace render {
namespace {

/// A pixel's view ray, scaled to reach one metre deep along the camera's axis.
glm::dvec3 viewRay(const pelagic::Camera& camera, VkExtent2D extent, std::uint32_t x, std::uint32_t y) {
  const double u = 2 * (x + 0.5) / extent.width - 1;
  const double v = 2 * (y + 0.5) / extent.height - 1;
  return {u / static_cast<double>(camera.projection[0][0]), v / static_cast<double>(camera.projection[1][1]), -1};
}

/// Distance along the axis [m] of a depth value of common::projection(); infinite where nothing was drawn.
double axialDistance(const pelagic::Camera& camera, float depth) {
  return static_cast<double>(camera.projection[3][2]) / static_cast<double>(depth);
}

std::vector<float> rayDistances(const std::vector<float>& depth, const pelagic::Camera& camera, VkExtent2D extent) {
  std::vector<float> distances(depth.size(), std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (!(depth[i] > 0)) continue;
    const glm::dvec3 ray = viewRay(camera, extent, static_cast<std::uint32_t>(i % extent.width),
                                   static_cast<std::uint32_t>(i / extent.width));
    distances[i] = static_cast<float>(glm::length(ray) * axialDistance(camera, depth[i]));
  }
  return distances;
}

std::vector<float> positions(const std::vector<float>& depth, const pelagic::Camera& camera, VkExtent2D extent) {
  std::vector<float> points(depth.size() * 3, 0.0f);
  const glm::dmat3 toWorld = glm::transpose(glm::dmat3(camera.rotation));
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (!(depth[i] > 0)) continue;
    const glm::dvec3 ray = viewRay(camera, extent, static_cast<std::uint32_t>(i % extent.width),
                                   static_cast<std::uint32_t>(i / extent.width));
    const glm::dvec3 point = camera.position + toWorld * ray * axialDistance(camera, depth[i]);
    for (int c = 0; c < 3; ++c) points[3 * i + static_cast<std::size_t>(c)] = static_cast<float>(point[c]);
  }
  return points;
}

/// The channels `names`, from component `first` on.
void add(std::vector<std::vector<float>>& storage, std::vector<common::ExrChannel>& channels, std::vector<float> pixels,
         std::size_t components, std::size_t first, std::vector<std::string> names) {
  storage.push_back(std::move(pixels));
  for (std::size_t i = 0; i < names.size(); ++i) {
    channels.push_back(common::floatChannel(std::move(names[i]), storage.back(), components, first + i));
  }
}

}  // namespace

void addAovs(const common::GpuDevice& gpu, const std::vector<Aov>& wanted, const AovImages& images,
             const pelagic::WaterBuffer& water, const pelagic::Camera& camera, std::vector<std::vector<float>>& storage,
             std::vector<common::ExrChannel>& channels) {
  const auto own = [&](const common::OwnedImage& image) {
    return common::readFloats(gpu, *image.image, image.format, image.extent, common::kTransferSource);
  };
  const VkExtent2D extent = water.depth.extent;
  for (const Aov aov : wanted) {
    switch (aov) {
      case Aov::depth:
        add(storage, channels, rayDistances(common::readFloats(gpu, water.depth), camera, extent), 1, 0, {"depth.Z"});
        break;
      case Aov::position:
        add(storage, channels, positions(common::readFloats(gpu, water.depth), camera, extent), 3, 0,
            {"position.X", "position.Y", "position.Z"});
        break;
      case Aov::normal:
        add(storage, channels, own(images.normal), 4, 0, {"normal.X", "normal.Y", "normal.Z"});
        break;
      case Aov::foam:
        add(storage, channels, own(images.normal), 4, 3, {"foam.V"});
        break;
      case Aov::variance:
        add(storage, channels, own(images.variance), 2, 0, {"variance.X", "variance.Y"});
        break;
      case Aov::body:
        add(storage, channels, common::readFloats(gpu, water.body), 1, 0, {"body.V"});
        break;
    }
  }
}

}  // namespace render
