#include "picture.hpp"

#include <common/failure.hpp>

namespace sandbox {
namespace {

using Usage = vk::ImageUsageFlagBits;

constexpr pelagic::ImageState kSampled{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                                       VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
// What the frame before left is overwritten: only its reads have to be over.
constexpr pelagic::ImageState kHdrBefore{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_NONE,
                                         VK_IMAGE_LAYOUT_UNDEFINED};
constexpr pelagic::ImageState kScreenBefore{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_NONE,
                                            VK_IMAGE_LAYOUT_UNDEFINED};

}  // namespace

Picture::Picture(const common::GpuDevice& gpu, pelagic::Device& device, vk::Extent2D extent)
    : hdr_(common::createImage(gpu, vk::Format::eR16G16B16A16Sfloat, extent, Usage::eStorage | Usage::eSampled,
                               "sandbox.hdr")),
      screen_(common::createImage(gpu, kFormat, extent, Usage::eStorage | Usage::eColorAttachment | Usage::eTransferSrc,
                                  "sandbox.screen")),
      toneMap_(common::unwrap(pelagic::ToneMap::create(
          device, {hdr_.host(kSampled, kSampled), screen_.host(kScreenBefore, kOverlayTarget)}))) {}

void Picture::bind(pelagic::Ocean& ocean) {
  pelagic::CompositeTargets targets;
  targets.output = hdr_.host(kHdrBefore, kSampled);
  view_ = common::unwrap(ocean.createView(targets));
}

void Picture::record(VkCommandBuffer commands, const pelagic::Camera& camera, const common::Scene& scene,
                     pelagic::Timings& timings) {
  view_->record(commands, camera, &timings);
  common::unwrap(toneMap_.setWhiteBalance(scene.whiteBalance));
  const auto exposure = static_cast<float>(scene.exposure);
  scene.metered ? toneMap_.recordMetered(commands, exposure, &timings) : toneMap_.record(commands, exposure, &timings);
}

}  // namespace sandbox
