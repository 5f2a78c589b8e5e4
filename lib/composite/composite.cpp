#include <array>
#include <composite/frame.hpp>
#include <composite/fresnel_table.hpp>
#include <composite/targets.hpp>
#include <cstring>
#include <gpu/barrier.hpp>
#include <gpu/compute_pass.hpp>
#include <map>

#include "composite_classify_comp.spv.hpp"
#include "composite_resolve_comp.spv.hpp"
#include "composite_sky_comp.spv.hpp"
#include "composite_water_comp.spv.hpp"

namespace pelagic {
namespace {

using vk::DescriptorType;

/// As in shaders/composite/bindings.glsl and tiles.glsl.
constexpr gpu::Binding kBindings[] = {
    {0, DescriptorType::eUniformBuffer},         {1, DescriptorType::eStorageBuffer},
    {2, DescriptorType::eUniformBuffer},         {3, DescriptorType::eCombinedImageSampler},
    {4, DescriptorType::eCombinedImageSampler},  {5, DescriptorType::eCombinedImageSampler},
    {6, DescriptorType::eCombinedImageSampler},  {7, DescriptorType::eCombinedImageSampler},
    {8, DescriptorType::eCombinedImageSampler},  {9, DescriptorType::eCombinedImageSampler},
    {10, DescriptorType::eCombinedImageSampler}, {11, DescriptorType::eCombinedImageSampler},
    {12, DescriptorType::eCombinedImageSampler}, {13, DescriptorType::eStorageImage},
    {14, DescriptorType::eStorageImage},         {15, DescriptorType::eStorageImage},
    {16, DescriptorType::eStorageImage},         {17, DescriptorType::eUniformTexelBuffer},
    {18, DescriptorType::eCombinedImageSampler}, {19, DescriptorType::eStorageImage},
    {20, DescriptorType::eStorageBuffer},        {21, DescriptorType::eCombinedImageSampler},
    {22, DescriptorType::eCombinedImageSampler},
};

/// As in shaders/composite/resolve.comp.
constexpr gpu::Binding kResolveBindings[] = {{0, DescriptorType::eCombinedImageSampler},
                                             {1, DescriptorType::eStorageBuffer},
                                             {2, DescriptorType::eStorageImage}};

constexpr gpu::BufferState kComputeReadWrite{
    vk::PipelineStageFlagBits2::eComputeShader,
    vk::AccessFlagBits2::eShaderStorageRead | vk::AccessFlagBits2::eShaderStorageWrite};
constexpr gpu::BufferState kComputeReadIndirect{
    vk::PipelineStageFlagBits2::eComputeShader | vk::PipelineStageFlagBits2::eDrawIndirect,
    vk::AccessFlagBits2::eShaderStorageRead | vk::AccessFlagBits2::eIndirectCommandRead};

/// The shaders' specialisation constants 0 … 10: which of a view's optional images there are, whether tiles foam,
/// whether there are a map of gains and clouds, whether a pipeline is for the night's tiles and for those behind
/// clouds, whether lights of the host shine, and whether the host's objects are behind air.
using Variant = std::array<std::uint32_t, 11>;
constexpr std::size_t kFoaming = 4, kNight = 7, kVeiled = 8, kHostLights = 9;

using TilePasses = std::array<gpu::ComputePass, shader::kTileLists>;  ///< Of each list of tiles.

struct Passes {
  gpu::ComputePass classify;
  TilePasses shade;
  /// Those of water with lights of the host, once there have been any.
  std::optional<TilePasses> lit;
};

}  // namespace

struct Composite::Impl {
  gpu::Context* context = nullptr;
  gpu::Unique<vk::Sampler> repeat;  ///< Wave maps and the clouds' shadow.
  gpu::Unique<vk::Sampler> azimuth;
  gpu::Unique<vk::Sampler> clamp;
  gpu::Unique<vk::Sampler> nearest;
  gpu::Buffer fresnel;
  gpu::Unique<vk::BufferView> fresnelView;
  gpu::ComputePass resolve;
  std::map<Variant, std::unique_ptr<Passes>> variants;
  std::vector<HostLight> lights;

  /// The passes of a variant, compiled when its first view is created.
  Result<const Passes*> passes(const Variant& variant);
  Result<void> light(const Variant& variant, Passes& entry);
  /// A pass of a variant with some of its constants set.
  Result<gpu::ComputePass> compile(std::string_view name, std::span<const std::uint32_t> code, Variant variant,
                                   std::initializer_list<std::size_t> set);
};

struct CompositeView::Impl {
  gpu::Context* context = nullptr;
  const Passes* passes = nullptr;
  const Composite::Impl* composite = nullptr;
  CompositeTargets targets;
  gpu::Buffer frame;
  gpu::Buffer tiles;
  gpu::Image shaded;  ///< The output where the surface breaks off: shaders/composite/edges.glsl.
  gpu::Buffer edges;
  gpu::DescriptorSet set;
  gpu::DescriptorSet resolveSet;

  Result<void> createEdges();
  void writeSet(const Composite::Impl& shared, const WaveMaps& waves, const SkyMaps& sky, const WaterBuffer& water);
  void recordInputs(vk::CommandBuffer commands, const shader::CompositeFrame& block) noexcept;
  void recordTargets(vk::CommandBuffer commands, bool before) noexcept;
};

Composite::Composite(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
Composite::Composite(Composite&&) noexcept = default;
Composite& Composite::operator=(Composite&&) noexcept = default;
Composite::~Composite() = default;

CompositeView::CompositeView(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
CompositeView::CompositeView(CompositeView&&) noexcept = default;
CompositeView& CompositeView::operator=(CompositeView&&) noexcept = default;
CompositeView::~CompositeView() = default;

Result<Composite> Composite::create(Device& device) {
  auto impl = std::make_unique<Impl>();
  impl->context = &device.context();
  const auto edge = vk::SamplerAddressMode::eClampToEdge;
  const auto sampler = [&](std::string_view name, const gpu::SamplerInfo& info) {
    return gpu::createSampler(*impl->context, name, info);
  };
  PELAGIC_TRY(repeat, sampler("composite repeat", {}));
  PELAGIC_TRY(azimuth, sampler("composite azimuth", {.v = edge}));
  PELAGIC_TRY(clamp, sampler("composite clamp", {.u = edge, .v = edge}));
  PELAGIC_TRY(nearest,
              sampler("composite nearest", {vk::Filter::eNearest, vk::SamplerMipmapMode::eNearest, edge, edge}));
  impl->repeat = std::move(repeat);
  impl->azimuth = std::move(azimuth);
  impl->clamp = std::move(clamp);
  impl->nearest = std::move(nearest);

  const std::vector<glm::u16vec4> table = fresnelTable();
  const std::size_t bytes = table.size() * sizeof(table[0]);
  PELAGIC_TRY(fresnel,
              gpu::Buffer::create(*impl->context, Stage::composite, "composite fresnel table", bytes,
                                  vk::BufferUsageFlagBits::eUniformTexelBuffer, gpu::Buffer::Placement::upload));
  std::memcpy(fresnel.mapped(), table.data(), bytes);
  impl->fresnel = std::move(fresnel);
  PELAGIC_TRY(fresnelView, gpu::createTexelView(*impl->context, "composite fresnel table", impl->fresnel,
                                                vk::Format::eR16G16B16A16Sfloat));
  impl->fresnelView = std::move(fresnelView);
  PELAGIC_TRY(resolve,
              gpu::ComputePass::create(
                  *impl->context, {"composite resolve", shaders::composite_resolve_comp, kResolveBindings, 0, {}}));
  impl->resolve = std::move(resolve);
  return Composite(std::move(impl));
}

Result<gpu::ComputePass> Composite::Impl::compile(std::string_view name, std::span<const std::uint32_t> code,
                                                  Variant variant, std::initializer_list<std::size_t> set) {
  for (const std::size_t i : set) variant[i] = 1;
  return gpu::ComputePass::create(*context, {name, code, kBindings, 0, variant});
}

Result<const Passes*> Composite::Impl::passes(const Variant& variant) {
  auto& entry = variants[variant];
  if (!entry) {
    const auto create = [&](std::string_view name, std::span<const std::uint32_t> code,
                            std::initializer_list<std::size_t> set) { return compile(name, code, variant, set); };
    PELAGIC_TRY(classify, create("composite classify", shaders::composite_classify_comp, {}));
    PELAGIC_TRY(sky, create("composite sky", shaders::composite_sky_comp, {}));
    PELAGIC_TRY(night, create("composite night", shaders::composite_sky_comp, {kNight}));
    PELAGIC_TRY(water, create("composite water", shaders::composite_water_comp, {}));
    PELAGIC_TRY(foam, create("composite foam", shaders::composite_water_comp, {kFoaming}));
    PELAGIC_TRY(veiled, create("composite veiled water", shaders::composite_water_comp, {kFoaming, kVeiled}));
    Passes passes{std::move(classify), {}, {}};
    passes.shade[shader::kSkyTiles] = std::move(sky);
    passes.shade[shader::kNightTiles] = std::move(night);
    passes.shade[shader::kWaterTiles] = std::move(water);
    passes.shade[shader::kFoamTiles] = std::move(foam);
    passes.shade[shader::kVeiledTiles] = std::move(veiled);
    entry = std::make_unique<Passes>(std::move(passes));
  }
  if (!lights.empty()) PELAGIC_CHECK(light(variant, *entry));
  return entry.get();
}

/// Adds the passes with lights.
Result<void> Composite::Impl::light(const Variant& variant, Passes& entry) {
  if (entry.lit) return {};
  const auto& code = shaders::composite_water_comp;
  PELAGIC_TRY(water, compile("composite lit water", code, variant, {kHostLights}));
  PELAGIC_TRY(foam, compile("composite lit foam", code, variant, {kHostLights, kFoaming}));
  PELAGIC_TRY(veiled, compile("composite lit veiled water", code, variant, {kHostLights, kFoaming, kVeiled}));
  TilePasses& lit = entry.lit.emplace();
  lit[shader::kWaterTiles] = std::move(water);
  lit[shader::kFoamTiles] = std::move(foam);
  lit[shader::kVeiledTiles] = std::move(veiled);
  return {};
}

Result<void> Composite::setLights(std::span<const HostLight> lights) {
  PELAGIC_CHECK(validate(lights));
  if (!lights.empty()) {
    for (auto& [variant, passes] : impl_->variants) {
      if (passes) PELAGIC_CHECK(impl_->light(variant, *passes));  // null where compilation has failed
    }
  }
  impl_->lights.assign(lights.begin(), lights.end());
  return {};
}

void CompositeView::Impl::writeSet(const Composite::Impl& shared, const WaveMaps& waves, const SkyMaps& sky,
                                   const WaterBuffer& water) {
  set.buffer(0, frame.handle());
  set.buffer(1, tiles.handle());
  set.buffer(2, sky.light);
  set.sampled(3, waves.gradient.view, *shared.repeat);
  set.sampled(4, waves.moments.view, *shared.repeat);
  set.sampled(5, waves.foam.view, *shared.repeat);
  set.sampled(6, sky.radiance.view, *shared.azimuth);
  set.sampled(7, sky.environment.view, *shared.clamp);
  set.sampled(8, water.position.view, *shared.nearest);
  set.sampled(9, water.body.view, *shared.nearest);
  set.sampled(10, water.depth.view, *shared.nearest);
  // What is missing is bound to what is there: the shader's constants keep it untouched.
  set.sampled(11, targets.color ? targets.color->view : water.position.view, *shared.nearest);
  set.sampled(12, targets.depth ? targets.depth->view : water.depth.view, *shared.nearest);
  set.storageImage(13, targets.output.view);
  const auto orOutput = [&](const std::optional<HostImage>& image) {
    return image ? image->view : targets.output.view;
  };
  set.storageImage(14, orOutput(targets.normal));
  set.storageImage(15, orOutput(targets.slopeVariance));
  set.storageImage(16, orOutput(targets.mergedDepth));
  set.texelBuffer(17, *shared.fresnelView);
  set.sampled(18, waves.gain.view ? waves.gain.view : waves.gradient.view, *shared.nearest);
  set.sampled(21, sky.clouds.view ? sky.clouds.view : sky.radiance.view, *shared.clamp);
  set.sampled(22, sky.cloudShadow.view ? sky.cloudShadow.view : sky.radiance.view, *shared.repeat);
  set.storageImage(19, shaded.mipView(0));
  set.buffer(20, edges.handle());
  resolveSet.sampled(0, shaded.view(), *shared.nearest);
  resolveSet.buffer(1, edges.handle());
  resolveSet.storageImage(2, targets.output.view);
}

/// What the smoothing of edges reads: the pixels on both sides of them, and their list.
Result<void> CompositeView::Impl::createEdges() {
  gpu::ImageInfo info;
  info.format = vk::Format::eR16G16B16A16Sfloat;
  info.extent = targets.output.extent;
  info.usage =
      vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst;
  PELAGIC_TRY(image, gpu::Image::create(*context, Stage::composite, "composite shaded", info));
  shaded = std::move(image);
  using Usage = vk::BufferUsageFlagBits;
  const vk::DeviceSize words = shader::kEdgeListStart + vk::DeviceSize{info.extent.width} * info.extent.height;
  PELAGIC_TRY(list, gpu::Buffer::create(*context, Stage::composite, "composite edges", words * sizeof(std::uint32_t),
                                        Usage::eStorageBuffer | Usage::eIndirectBuffer | Usage::eTransferDst));
  edges = std::move(list);
  return {};
}

Result<CompositeView> CompositeView::create(Composite& composite, const WaveMaps& waves, const SkyMaps& sky,
                                            const WaterBuffer& water, const CompositeTargets& targets) {
  PELAGIC_CHECK(validate(targets, water));
  PELAGIC_CHECK(validate(sky, water));
  Composite::Impl& shared = *composite.impl_;
  auto impl = std::make_unique<Impl>();
  impl->context = shared.context;
  impl->targets = targets;
  const Variant variant{targets.color.has_value(),
                        targets.normal.has_value(),
                        targets.slopeVariance.has_value(),
                        targets.mergedDepth.has_value(),
                        0,
                        waves.gain.view != VK_NULL_HANDLE,
                        sky.clouds.view != VK_NULL_HANDLE && sky.cloudShadow.view != VK_NULL_HANDLE,
                        0,
                        0,
                        0,
                        targets.color && targets.airBeforeHost};
  PELAGIC_TRY(passes, shared.passes(variant));
  impl->passes = passes;
  impl->composite = &shared;

  using Usage = vk::BufferUsageFlagBits;
  PELAGIC_TRY(frame, gpu::Buffer::create(*impl->context, Stage::composite, "composite frame",
                                         sizeof(shader::CompositeFrame), Usage::eUniformBuffer | Usage::eTransferDst));
  const VkExtent2D extent = targets.output.extent;
  const vk::DeviceSize count =
      vk::DeviceSize{gpu::groups(extent.width, shader::kTileSize)} * gpu::groups(extent.height, shader::kTileSize);
  PELAGIC_TRY(tiles,
              gpu::Buffer::create(*impl->context, Stage::composite, "composite tiles",
                                  (shader::kTileListStart + 2 * shader::kTileLists * count) * sizeof(std::uint32_t),
                                  Usage::eStorageBuffer | Usage::eIndirectBuffer | Usage::eTransferDst));
  impl->frame = std::move(frame);
  impl->tiles = std::move(tiles);
  PELAGIC_TRY(set, impl->passes->classify.createSet("composite view"));
  impl->set = std::move(set);
  PELAGIC_TRY(resolveSet, shared.resolve.createSet("composite resolve"));
  impl->resolveSet = std::move(resolveSet);
  PELAGIC_CHECK(impl->createEdges());
  impl->writeSet(shared, waves, sky, water);
  return CompositeView(std::move(impl));
}

void CompositeView::Impl::recordInputs(vk::CommandBuffer commands, const shader::CompositeFrame& block) noexcept {
  gpu::Barrier()
      .buffer(frame, gpu::kTransferWrite)
      .buffer(tiles, gpu::kTransferWrite)
      .buffer(edges, gpu::kTransferWrite)
      .image(shaded, gpu::kTransferDestination, true)
      .record(*context, commands);
  commands.updateBuffer(frame.handle(), 0, sizeof(block), &block, context->dispatch);
  // Per list an indirect dispatch of no groups, and no tiles.
  std::array<std::uint32_t, 4 * shader::kTileLists> empty{};
  for (std::size_t list = 0; list < shader::kTileLists; ++list) empty[4 * list + 2] = 1;
  commands.updateBuffer(tiles.handle(), 0, sizeof(empty), empty.data(), context->dispatch);
  commands.updateBuffer(edges.handle(), 0, 4 * sizeof(std::uint32_t), empty.data(), context->dispatch);
  commands.clearColorImage(shaded.handle(), vk::ImageLayout::eTransferDstOptimal, vk::ClearColorValue{}, shaded.range(),
                           context->dispatch);
  gpu::Barrier()
      .buffer(frame, gpu::kComputeRead)
      .buffer(tiles, kComputeReadWrite)
      .buffer(edges, kComputeReadWrite)
      .image(shaded, gpu::kComputeStorageWrite)
      .record(*context, commands);
}

void CompositeView::Impl::recordTargets(vk::CommandBuffer commands, bool before) noexcept {
  gpu::Barrier barrier;
  const auto add = [&](const HostImage& image, const ImageState& inside, bool written, vk::ImageAspectFlags aspect) {
    ImageState outside = before ? image.before : image.after;
    if (before && written) outside.layout = VK_IMAGE_LAYOUT_UNDEFINED;  // every pixel is written
    barrier.image(image.image, aspect, before ? outside : inside, before ? inside : outside);
  };
  const auto color = vk::ImageAspectFlagBits::eColor;
  add(targets.output, gpu::kComputeStorageWrite, true, color);
  for (const auto* image : {&targets.normal, &targets.slopeVariance, &targets.mergedDepth}) {
    if (*image) add(**image, gpu::kComputeStorageWrite, true, color);
  }
  if (targets.color) {
    add(*targets.color, gpu::kComputeSampled, false, color);
    add(*targets.depth, gpu::kComputeSampled, false, vk::ImageAspectFlagBits::eDepth);
  }
  barrier.record(*context, commands);
}

void CompositeView::record(VkCommandBuffer commandBuffer, const WaveMaps& waves, const WaterBuffer& water,
                           const Camera& camera, const WaterMedium& medium, Timings* timings) noexcept {
  const vk::CommandBuffer commands(commandBuffer);
  Impl& view = *impl_;
  const VkExtent2D extent = view.targets.output.extent;
  const auto measured = [&](const char* name, const auto& pass) {
    if (timings) timings->begin(commandBuffer, name);
    pass();
    if (timings) timings->end(commandBuffer);
  };
  measured("composite classify", [&] {
    view.recordInputs(commands, compositeFrame(waves, water, camera, medium, extent, view.composite->lights));
    view.recordTargets(commands, true);
    view.passes->classify.bind(commands, view.set);
    // A tile an invocation, 8 x 8 of them a group.
    view.passes->classify.dispatch(commands, gpu::groups(extent.width, 8 * shader::kTileSize),
                                   gpu::groups(extent.height, 8 * shader::kTileSize));
    gpu::Barrier().buffer(view.tiles, kComputeReadIndirect).record(*view.context, commands);
  });
  const auto shade = [&](const TilePasses& passes, std::uint32_t list) {
    passes[list].bind(commands, view.set);
    passes[list].dispatchIndirect(commands, view.tiles.handle(), list * 4 * sizeof(std::uint32_t));
  };
  measured("composite sky", [&] {
    shade(view.passes->shade, shader::kSkyTiles);
    shade(view.passes->shade, shader::kNightTiles);
  });
  measured("composite water", [&] {
    const TilePasses& ofWater = view.composite->lights.empty() ? view.passes->shade : *view.passes->lit;
    shade(ofWater, shader::kWaterTiles);
    shade(ofWater, shader::kFoamTiles);
    shade(ofWater, shader::kVeiledTiles);
  });
  measured("composite resolve", [&] {
    gpu::Barrier barrier;
    barrier.image(view.shaded, gpu::kComputeSampled).buffer(view.edges, kComputeReadIndirect);
    barrier.image(view.targets.output.image, vk::ImageAspectFlagBits::eColor, gpu::kComputeStorageWrite,
                  gpu::kComputeStorageWrite);
    barrier.record(*view.context, commands);
    view.composite->resolve.bind(commands, view.resolveSet);
    view.composite->resolve.dispatchIndirect(commands, view.edges.handle(), 0);
  });
  view.recordTargets(commands, false);
}

}  // namespace pelagic
