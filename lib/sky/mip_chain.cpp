#include <shared/sky_pass.h>

#include <sky/mip_chain.hpp>

#include "sky_environment_mip_comp.spv.hpp"

namespace pelagic::sky {

Result<MipChain> MipChain::create(gpu::Context& context, std::string_view name, const gpu::Image& map,
                                  vk::Sampler sampler) {
  const gpu::Binding bindings[] = {{0, vk::DescriptorType::eCombinedImageSampler, 1},
                                   {1, vk::DescriptorType::eStorageImage, 1}};
  MipChain chain;
  PELAGIC_TRY(pass, gpu::ComputePass::create(context, {name, shaders::sky_environment_mip_comp, bindings, 0, {}}));
  chain.pass_ = std::move(pass);
  for (std::uint32_t i = 0; i + 1 < map.info().mips; ++i) {
    PELAGIC_TRY(set, chain.pass_.createSet(name));
    set.sampled(0, map.mipView(i), sampler);
    set.storageImage(1, map.mipView(i + 1));
    chain.sets_.push_back(std::move(set));
  }
  return chain;
}

void MipChain::record(const gpu::Context& context, vk::CommandBuffer commands, gpu::Image& map) const noexcept {
  gpu::Barrier barrier;
  for (std::uint32_t i = 0; i < map.info().mips; ++i) {
    barrier.mip(map, i, gpu::kComputeStorageWrite, kShaderRead).record(context, commands);
    if (i == sets_.size()) break;
    pass_.bind(commands, sets_[i]);
    const std::uint32_t groups = gpu::groups(map.info().extent.width >> (i + 1), shader::kSkyTile);
    pass_.dispatch(commands, groups, groups);
  }
  map.state = kShaderRead;
}

}  // namespace pelagic::sky
