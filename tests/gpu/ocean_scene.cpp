#include "ocean_scene.hpp"

#include <cmath>

namespace support {

double luminance(const glm::dvec3& radiance) { return glm::dot(radiance, glm::dvec3(0.2126, 0.7152, 0.0722)); }

glm::dvec3 Drawn::at(std::uint32_t x, std::uint32_t y) const {
  const float* p = &radiance[4 * (std::size_t{y} * extent.width + x)];
  return {p[0], p[1], p[2]};
}

double Drawn::luminanceAt(std::uint32_t x, std::uint32_t y) const { return luminance(at(x, y)); }

double Drawn::distanceAt(std::uint32_t x, std::uint32_t y) const {
  return static_cast<double>(common::kNearPlane / depth[std::size_t{y} * extent.width + x]);
}

OceanScene::OceanScene(const common::GpuDevice& gpu, pelagic::Device& device, const std::string& name, float targetEdge,
                       const std::function<void(common::Scene&)>& change, const pelagic::GainMap& gain)
    : gpu_(&gpu) {
  common::loadScene("--scene", name, scene_);
  if (change) change(scene_);
  pelagic::OceanInfo info = common::oceanInfo(scene_);
  info.surface.targetEdge = targetEdge;
  info.waves.gain = gain;
  ocean_.emplace(pelagic::Ocean::create(device, info).value());
}

std::size_t OceanScene::addView(VkExtent2D extent) {
  using Usage = vk::ImageUsageFlagBits;
  const auto image = [&](vk::Format format) {
    return common::createImage(*gpu_, format, extent, Usage::eStorage | Usage::eTransferSrc, "scene");
  };
  common::OwnedImage radiance = image(vk::Format::eR32G32B32A32Sfloat), depth = image(vk::Format::eR32Sfloat);
  common::OwnedImage normal = image(vk::Format::eR32G32B32A32Sfloat);
  pelagic::CompositeTargets targets;
  targets.output = radiance.host({}, common::kTransferSource);
  targets.mergedDepth = depth.host({}, common::kTransferSource);
  targets.normal = normal.host({}, common::kTransferSource);
  pelagic::OceanView view = ocean_->createView(targets).value();
  targets_.push_back({std::move(radiance), std::move(depth), std::move(normal), std::move(view)});
  return targets_.size() - 1;
}

void OceanScene::setTime(double seconds) {
  gpu_->run([&](vk::CommandBuffer commands) { ocean_->record(commands, seconds); });
}

Drawn OceanScene::draw(std::size_t view, const common::View& from, double roll) {
  Target& target = targets_[view];
  const vk::Extent2D extent = target.radiance.extent;
  pelagic::Camera camera = common::cameraOf(from, static_cast<double>(extent.width) / extent.height);
  const auto c = static_cast<float>(std::cos(roll)), s = static_cast<float>(std::sin(roll));
  camera.rotation = glm::mat3(c, -s, 0, s, c, 0, 0, 0, 1) * camera.rotation;
  gpu_->run([&](vk::CommandBuffer commands) { target.view.record(commands, camera); });
  const auto read = [&](const common::OwnedImage& image) {
    return common::readFloats(*gpu_, *image.image, image.format, image.extent, common::kTransferSource);
  };
  const std::vector<float> normal = read(target.normal);
  std::vector<float> foam;
  for (std::size_t i = 3; i < normal.size(); i += 4) foam.push_back(normal[i]);
  return {extent, read(target.radiance), std::move(foam), read(target.depth)};
}

common::View fromAbove(const common::Scene& scene, double turn) {
  const glm::dvec3 ahead = scene.view.lookAt - scene.view.position;
  const double heading = std::atan2(ahead.z, ahead.x) + turn;
  common::View view;
  view.position = {0, 8, 0};
  view.lookAt = view.position + glm::dvec3(std::cos(heading), -0.04, std::sin(heading));
  view.fov = 45;
  return view;
}

}  // namespace support
