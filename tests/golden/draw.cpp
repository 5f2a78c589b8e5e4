#include "draw.hpp"

#include <stdexcept>

namespace golden {

namespace {

template <class T>
T require(pelagic::Result<T>&& result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

}  // namespace

common::Scene builtin(std::string_view name) {
  common::Scene scene;
  common::loadScene("scene", std::string(name), scene);
  return scene;
}

Picture draw(const common::GpuDevice& gpu, const pelagic::DeviceInfo& handles, const common::Scene& scene) {
  using Usage = vk::ImageUsageFlagBits;
  const auto hdr = common::createImage(gpu, vk::Format::eR32G32B32A32Sfloat, kExtent,
                                       Usage::eStorage | Usage::eTransferSrc, "golden.hdr");
  pelagic::Device device = require(pelagic::Device::create(handles));
  pelagic::Ocean ocean = require(pelagic::Ocean::create(device, common::oceanInfo(scene)));
  pelagic::CompositeTargets targets;
  targets.output = hdr.host(common::kUndefined, common::kTransferSource);
  pelagic::OceanView view = require(ocean.createView(targets));
  const pelagic::Camera camera = common::cameraOf(scene.view, double{kExtent.width} / kExtent.height);
  gpu.run([&](vk::CommandBuffer commands) {
    ocean.record(commands, scene.time);
    view.record(commands, camera);
  });
  const auto rgba = common::readFloats(gpu, *hdr.image, hdr.format, kExtent, common::kTransferSource);
  return encode(kExtent.width, kExtent.height, rgba, scene.exposure);
}

std::filesystem::path imageOf(std::string_view scene) {
  return std::filesystem::path(PELAGIC_GOLDEN_IMAGES) / (std::string(scene) + ".png");
}

}  // namespace golden
