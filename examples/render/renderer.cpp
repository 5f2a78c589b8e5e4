#include "renderer.hpp"

#include <algorithm>
#include <common/failure.hpp>
#include <cstring>

namespace render {
namespace {

constexpr pelagic::ImageState kSampled{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                                       VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};

bool wants(const std::vector<Aov>& aovs, Aov aov) { return std::find(aovs.begin(), aovs.end(), aov) != aovs.end(); }

}  // namespace

Renderer::Renderer(const common::GpuDevice& gpu, pelagic::Device& device, const RendererInfo& info)
    : gpu_(&gpu),
      info_(info),
      camera_(common::cameraOf(info.scene.view, static_cast<double>(info.extent.width) / info.extent.height)),
      ocean_(common::unwrap(pelagic::Ocean::create(device, common::oceanInfo(info.scene)))),
      timings_(common::unwrap(pelagic::Timings::create(device))) {
  using Usage = vk::ImageUsageFlagBits;
  const vk::ImageUsageFlags usage = Usage::eStorage | Usage::eTransferSrc;
  const auto image = [&](vk::Format format, vk::ImageUsageFlags more, const char* name) {
    return common::createImage(gpu, format, info.extent, usage | more, name);
  };
  const bool png = info.format == Format::png;
  pelagic::CompositeTargets targets;
  hdr_ = image(vk::Format::eR16G16B16A16Sfloat, Usage::eSampled, "render.hdr");
  targets.output = hdr_.host(common::kUndefined, png ? kSampled : common::kTransferSource);
  if (wants(info.aovs, Aov::normal) || wants(info.aovs, Aov::foam)) {
    aovImages_.normal = image(vk::Format::eR32G32B32A32Sfloat, {}, "render.normal");
    targets.normal = aovImages_.normal.host(common::kUndefined, common::kTransferSource);
  }
  if (wants(info.aovs, Aov::variance)) {
    aovImages_.variance = image(vk::Format::eR32G32Sfloat, {}, "render.variance");
    targets.slopeVariance = aovImages_.variance.host(common::kUndefined, common::kTransferSource);
  }
  view_ = common::unwrap(ocean_.createView(targets));
  if (png) {
    ldr_ = image(vk::Format::eR8G8B8A8Unorm, {}, "render.ldr");
    toneMap_ = common::unwrap(pelagic::ToneMap::create(
        device, {hdr_.host(kSampled, kSampled), ldr_.host(common::kUndefined, common::kTransferSource)}));
  }
}

std::span<const pelagic::Timings::Pass> Renderer::draw(double time) {
  gpu_->run([&](vk::CommandBuffer commands) {
    timings_.reset(commands);
    ocean_.record(commands, time, &timings_);
    view_->record(commands, camera_, &timings_);
    if (toneMap_) common::unwrap(toneMap_->setWhiteBalance(info_.scene.whiteBalance));
    const auto exposure = static_cast<float>(info_.scene.exposure);
    if (toneMap_ && info_.scene.metered) toneMap_->recordMetered(commands, exposure, &timings_);
    if (toneMap_ && !info_.scene.metered) toneMap_->record(commands, exposure, &timings_);
  });
  return common::unwrap(timings_.read());
}

void Renderer::write(const std::filesystem::path& path) const {
  if (info_.format == Format::exr) return writeLinear(path);
  const auto pixels = common::readImage(*gpu_, *ldr_.image, ldr_.format, ldr_.extent, common::kTransferSource);
  common::writePng(path, info_.extent.width, info_.extent.height, pixels);
}

void Renderer::writeLinear(const std::filesystem::path& path) const {
  const auto color = common::readImage(*gpu_, *hdr_.image, hdr_.format, hdr_.extent, common::kTransferSource);
  constexpr std::size_t kPixel = 8;  // bytes of rgba16f
  std::vector<common::ExrChannel> channels{
      {"R", true, color.data(), kPixel}, {"G", true, color.data() + 2, kPixel}, {"B", true, color.data() + 4, kPixel}};
  std::vector<std::vector<float>> storage;
  addAovs(*gpu_, info_.aovs, aovImages_, view_->waterBuffer(), camera_, storage, channels);
  common::writeExr(path, info_.extent.width, info_.extent.height, channels);
}

std::uint32_t Renderer::triangles() const {
  const auto bytes = common::readBuffer(*gpu_, view_->drawArguments(), sizeof(VkDrawIndexedIndirectCommand));
  VkDrawIndexedIndirectCommand draw{};
  std::memcpy(&draw, bytes.data(), sizeof draw);
  return draw.indexCount / 3 * draw.instanceCount;
}

}  // namespace render
