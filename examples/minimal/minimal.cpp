/// pelagic-minimal: the shortest correct host. One ocean, one view, one frame, written to minimal.png.
#include <common/failure.hpp>
#include <common/image_file.hpp>
#include <common/program.hpp>
#include <common/view.hpp>
#include <pelagic/ocean.hpp>

namespace {

constexpr vk::Extent2D kExtent{640, 360};
/// How the tone map's compute shader reads an image.
constexpr pelagic::ImageState kSampled{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                                       VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};

void drawOneFrame(common::Program& program, common::OutputSet& outputs) {
  using common::unwrap;
  using Usage = vk::ImageUsageFlagBits;
  const auto file = outputs.add("the output", "minimal.png");

  // 1. The host's own: a Vulkan device and two images, one for linear radiance, one for the screen.
  const common::GpuDevice gpu = program.openDevice();
  const auto hdr = common::createImage(gpu, vk::Format::eR16G16B16A16Sfloat, kExtent, Usage::eStorage | Usage::eSampled,
                                       "minimal.hdr");
  const auto screen = common::createImage(gpu, vk::Format::eR8G8B8A8Unorm, kExtent,
                                          Usage::eStorage | Usage::eTransferSrc, "minimal.screen");

  // 2. The ocean: a sea state, the patches that can hold it, and the view that draws into the host's image.
  pelagic::Device device = unwrap(pelagic::Device::create(gpu.info()));
  pelagic::OceanInfo info;
  info.waves.sea.windSpeed = 8;
  info.waves.layout = unwrap(pelagic::waveLayout(info.waves.sea));
  pelagic::Ocean ocean = unwrap(pelagic::Ocean::create(device, info));
  pelagic::CompositeTargets targets;
  targets.output = hdr.host(common::kUndefined, kSampled);
  pelagic::OceanView view = unwrap(ocean.createView(targets));
  pelagic::ToneMap toneMap = unwrap(pelagic::ToneMap::create(
      device, {hdr.host(kSampled, kSampled), screen.host(common::kUndefined, common::kTransferSource)}));

  // 3. A frame: advance the sea, draw it, make it fit for a screen.
  const pelagic::Camera camera = common::cameraOf(common::View{}, double{kExtent.width} / kExtent.height);
  gpu.run([&](vk::CommandBuffer commands) {
    ocean.record(commands, 0);
    view.record(commands, camera);
    toneMap.record(commands, 2);
  });
  const auto pixels = common::readImage(gpu, *screen.image, screen.format, kExtent, common::kTransferSource);
  common::writePng(file, kExtent.width, kExtent.height, pixels);
}

}  // namespace

int main(int argc, char** argv) {
  common::Program program("pelagic-minimal", "The shortest host of an ocean: writes one picture, minimal.png.");
  return program.run(argc, argv, [&](common::OutputSet& outputs) { drawOneFrame(program, outputs); });
}
