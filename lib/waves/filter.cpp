#include "filter.hpp"

#include <algorithm>

#include "waves_filter_half.spv.hpp"
#include "waves_filter_single.spv.hpp"

namespace pelagic {
namespace {

constexpr ImageState kComputeStorage{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                                     VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                                     VK_IMAGE_LAYOUT_GENERAL};
constexpr std::uint32_t kMaps = 4;

}  // namespace

Result<WaveFilter> WaveFilter::create(gpu::Context& context, const WavesInfo& info, const WaveImages& images) {
  WaveFilter result;
  result.context_ = &context;
  result.size_ = info.layout.size;
  result.count_ = info.layout.count;
  result.foamCascades_ = foamCascades(info.layout);
  result.mips_ = images.foam.info().mips;
  std::array<gpu::Binding, 2 * kMaps> bindings;
  for (std::uint32_t map = 0; map < kMaps; ++map) {
    bindings[map] = {map, vk::DescriptorType::eStorageImage};
    bindings[kMaps + map] = {kMaps + map, vk::DescriptorType::eStorageImage, shader::kFilterLevels};
  }
  const auto code = info.precision == MapPrecision::half ? shaders::waves_filter_half : shaders::waves_filter_single;
  PELAGIC_TRY(pass,
              gpu::ComputePass::create(context, {"waves filter", code, bindings, sizeof(shader::WaveFilterPush), {}}));
  result.pass_ = std::move(pass);
  for (std::uint32_t target = 0; target < 2; ++target) {
    const gpu::Image* maps[kMaps] = {&images.displacement[target], &images.gradient, &images.moments, &images.foam};
    for (std::uint32_t step = 0; step < 2; ++step) {
      PELAGIC_TRY(set, result.pass_.createSet("waves filter"));
      const std::uint32_t source = step * shader::kFilterLevels;
      for (std::uint32_t map = 0; map < kMaps; ++map) {
        set.storageImage(map, maps[map]->mipView(source));
        for (std::uint32_t level = 0; level < shader::kFilterLevels; ++level) {
          // Levels beyond the last mip are not written.
          set.storageImage(kMaps + map, maps[map]->mipView(std::min(source + level + 1, result.mips_ - 1)), level);
        }
      }
      result.sets_[target][step] = std::move(set);
    }
  }
  return result;
}

void WaveFilter::record(vk::CommandBuffer commands, WaveImages& images, std::uint32_t target) noexcept {
  for (std::uint32_t step = 0; step < 2; ++step) {
    gpu::Barrier()
        .image(images.displacement[target], kComputeStorage)
        .image(images.gradient, kComputeStorage)
        .image(images.moments, kComputeStorage)
        .image(images.foam, kComputeStorage)
        .record(*context_, commands);
    const std::uint32_t source = step * shader::kFilterLevels;
    const std::uint32_t size = size_ >> source;
    const std::uint32_t tiles = gpu::groups(size, 1u << shader::kFilterLevels);
    pass_.bind(commands, sets_[target][step]);
    pass_.push(commands,
               shader::WaveFilterPush{size, std::min(shader::kFilterLevels, mips_ - 1 - source), foamCascades_});
    pass_.dispatch(commands, tiles, tiles, count_);
  }
}

}  // namespace pelagic
