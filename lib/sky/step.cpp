#include <bit>
#include <sky/step.hpp>

namespace pelagic::sky {

std::array<std::uint32_t, 2> aroundPlanet(double radius) noexcept {
  return {0, std::bit_cast<std::uint32_t>(static_cast<float>(radius))};
}

Result<Step> createStep(gpu::Context& context, std::string_view name, std::span<const std::uint32_t> code,
                        std::initializer_list<vk::DescriptorType> types, std::uint32_t pushBytes,
                        std::span<const std::uint32_t> constants) {
  std::vector<gpu::Binding> bindings;
  for (const auto type : types) bindings.push_back({static_cast<std::uint32_t>(bindings.size()), type, 1});
  Step step;
  PELAGIC_TRY(pass, gpu::ComputePass::create(context, {name, code, bindings, pushBytes, constants}));
  step.pass = std::move(pass);
  PELAGIC_TRY(set, step.pass.createSet(name));
  step.set = std::move(set);
  return step;
}

Result<gpu::Image> createMap(gpu::Context& context, std::string_view name, vk::Extent2D extent, std::uint32_t mips,
                             vk::Format format, std::uint32_t depth) {
  using Usage = vk::ImageUsageFlagBits;
  gpu::ImageInfo info;
  info.format = format;
  info.extent = extent;
  info.depth = depth;
  info.mips = mips;
  info.usage = Usage::eStorage | Usage::eSampled | Usage::eTransferSrc | Usage::eTransferDst;
  return gpu::Image::create(context, Stage::sky, name, info);
}

void clearMap(const gpu::Context& context, vk::CommandBuffer commands, gpu::Image& map,
              const std::array<float, 4>& value) noexcept {
  gpu::Barrier().image(map, gpu::kTransferDestination, true).record(context, commands);
  commands.clearColorImage(map.handle(), vk::ImageLayout::eTransferDstOptimal, vk::ClearColorValue(value), map.range(),
                           context.dispatch);
  gpu::Barrier().image(map, kShaderRead).record(context, commands);
}

}  // namespace pelagic::sky
