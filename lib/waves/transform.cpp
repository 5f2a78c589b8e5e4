#include "transform.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "waves_columns.spv.hpp"
#include "waves_foam.spv.hpp"
#include "waves_rows.spv.hpp"

namespace pelagic {
namespace {

using vk::DescriptorType;
using Usage = vk::BufferUsageFlagBits;

/// Lines of a work-group: 8 neighbouring columns where 32 KiB of shared memory hold them.
std::uint32_t columnsPerGroup(std::uint32_t size) noexcept { return std::min(8u, 2048 / size); }
/// As many rows as fit beside the padding of the exchange.
std::uint32_t rowsPerGroup(std::uint32_t size) noexcept { return size == 1024 ? 1 : std::min(8u, 1024 / size); }

/// Modes with an index in [band, size - band) along either axis are zero in every cascade.
std::uint32_t bandOf(const WaveLayout& layout) noexcept {
  double highest = 0;
  for (std::uint32_t c = 0; c < layout.count; ++c) {
    highest = std::max(highest, layout.cascades[c].kMax * layout.cascades[c].length / (2 * std::numbers::pi));
  }
  constexpr std::uint32_t kMostRowsPerGroup = 8;
  const double half = 0.5 * layout.size;
  const auto modes = static_cast<std::uint32_t>(std::min(std::ceil(highest) + 1, half));
  return std::min(gpu::groups(modes, kMostRowsPerGroup) * kMostRowsPerGroup, layout.size / 2);
}

}  // namespace

Result<WaveImages> createWaveImages(gpu::Context& context, const WavesInfo& info) {
  const bool half = info.precision == MapPrecision::half;
  gpu::ImageInfo image;
  image.format = half ? vk::Format::eR16G16B16A16Sfloat : vk::Format::eR32G32B32A32Sfloat;
  image.extent = vk::Extent2D(info.layout.size, info.layout.size);
  image.layers = info.layout.count;
  image.mips = gpu::mipCount(image.extent);
  image.array = true;
  image.usage =
      vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferSrc;
  // Filtering of 32-bit floats is optional in Vulkan.
  const vk::FormatFeatureFlags features = vk::FormatFeatureFlagBits::eStorageImage |
                                          vk::FormatFeatureFlagBits::eSampledImage |
                                          vk::FormatFeatureFlagBits::eSampledImageFilterLinear;
  PELAGIC_CHECK(gpu::requireFormat(context, image.format, features));
  WaveImages images;
  PELAGIC_TRY(displacement0, gpu::Image::create(context, Stage::waves, "waves displacement 0", image));
  images.displacement[0] = std::move(displacement0);
  PELAGIC_TRY(displacement1, gpu::Image::create(context, Stage::waves, "waves displacement 1", image));
  images.displacement[1] = std::move(displacement1);
  PELAGIC_TRY(gradient, gpu::Image::create(context, Stage::waves, "waves gradient", image));
  images.gradient = std::move(gradient);
  PELAGIC_TRY(moments, gpu::Image::create(context, Stage::waves, "waves moments", image));
  images.moments = std::move(moments);
  image.format = half ? vk::Format::eR16Sfloat : vk::Format::eR32Sfloat;
  image.usage |= vk::ImageUsageFlagBits::eTransferDst;
  PELAGIC_CHECK(gpu::requireFormat(context, image.format, features));
  PELAGIC_TRY(foam, gpu::Image::create(context, Stage::waves, "waves foam", image));
  images.foam = std::move(foam);
  return images;
}

Result<WaveTransform> WaveTransform::create(gpu::Context& context, const WavesInfo& info, const WaveImages& images) {
  WaveTransform result;
  result.context_ = &context;
  result.size_ = info.layout.size;
  result.count_ = info.layout.count;
  result.foamCascades_ = foamCascades(info.layout);
  result.band_ = bandOf(info.layout);
  result.rowsPerGroup_ = rowsPerGroup(info.layout.size);
  result.columnsPerGroup_ = columnsPerGroup(info.layout.size);
  PELAGIC_CHECK(result.createBuffers(context, info));
  PELAGIC_CHECK(result.createPasses(context, info));
  PELAGIC_CHECK(result.createSets(images));
  return result;
}

Result<void> WaveTransform::createBuffers(gpu::Context& context, const WavesInfo& info) {
  const vk::DeviceSize texels = vk::DeviceSize{size_} * size_ * count_;
  const std::uint32_t limit = context.properties.limits.maxTexelBufferElements;
  if (2 * texels > limit) {
    return gpu::reject("WaveLayout::size and ::count need " + std::to_string(2 * texels) +
                           " elements in a texel buffer, the device has " + std::to_string(limit),
                       ErrorCode::unsupported);
  }
  const auto create = [&](gpu::Buffer& buffer, std::string_view name, vk::DeviceSize size,
                          vk::BufferUsageFlags usage) -> Result<void> {
    PELAGIC_TRY(made, gpu::Buffer::create(context, Stage::waves, name, size, usage));
    buffer = std::move(made);
    return {};
  };
  const vk::BufferUsageFlags modes = Usage::eUniformTexelBuffer | Usage::eTransferDst;
  PELAGIC_CHECK(create(cascades_, "waves cascades", 2 * sizeof(shader::WaveCascade) * kMaxCascades,
                       Usage::eStorageBuffer | Usage::eTransferDst));
  PELAGIC_CHECK(create(amplitudes_, "waves amplitudes", 2 * sizeof(glm::vec4) * texels, modes));
  PELAGIC_CHECK(create(constants_, "waves mode constants", 2 * sizeof(ModeConstants) * texels, modes));
  PELAGIC_CHECK(create(planes_, "waves rows", 2 * sizeof(glm::vec4) * texels,
                       Usage::eUniformTexelBuffer | Usage::eStorageBuffer));
  const vk::DeviceSize history = vk::DeviceSize{size_} * size_ * foamCascades_ * sizeof(std::uint32_t);
  PELAGIC_CHECK(create(history_[0], "waves foam history 0", history, Usage::eStorageBuffer | Usage::eTransferDst));
  PELAGIC_CHECK(create(history_[1], "waves foam history 1", history, Usage::eStorageBuffer | Usage::eTransferDst));
  for (std::uint32_t i = 0; i < info.framesInFlight; ++i) {
    PELAGIC_TRY(staging, gpu::Buffer::create(context, Stage::waves, "waves staging " + std::to_string(i),
                                             cascades_.size() + amplitudes_.size() + constants_.size(),
                                             Usage::eTransferSrc, gpu::Buffer::Placement::upload));
    staging_.push_back(std::move(staging));
  }
  PELAGIC_TRY(amplitudes,
              gpu::createTexelView(context, "waves amplitudes", amplitudes_, vk::Format::eR32G32B32A32Sfloat));
  PELAGIC_TRY(constants,
              gpu::createTexelView(context, "waves mode constants", constants_, vk::Format::eR32G32B32A32Uint));
  PELAGIC_TRY(planes, gpu::createTexelView(context, "waves rows", planes_, vk::Format::eR32G32B32A32Sfloat));
  amplitudesView_ = std::move(amplitudes);
  constantsView_ = std::move(constants);
  planesView_ = std::move(planes);
  return {};
}

Result<void> WaveTransform::createPasses(gpu::Context& context, const WavesInfo&) {
  const std::uint32_t threads = size_ / shader::kSamplesPerThread;
  const gpu::Binding rowBindings[] = {{0, DescriptorType::eUniformTexelBuffer},
                                      {1, DescriptorType::eUniformTexelBuffer},
                                      {2, DescriptorType::eStorageBuffer},
                                      {3, DescriptorType::eStorageBuffer}};
  const gpu::Binding columnBindings[] = {{0, DescriptorType::eUniformTexelBuffer}, {1, DescriptorType::eStorageBuffer},
                                         {2, DescriptorType::eStorageBuffer},      {3, DescriptorType::eStorageImage},
                                         {4, DescriptorType::eStorageImage},       {5, DescriptorType::eStorageImage},
                                         {6, DescriptorType::eStorageImage}};
  const gpu::Binding foamBindings[] = {{0, DescriptorType::eUniformTexelBuffer},
                                       {1, DescriptorType::eStorageBuffer},
                                       {2, DescriptorType::eStorageBuffer},
                                       {3, DescriptorType::eStorageBuffer}};
  const std::uint32_t column[] = {columnsPerGroup_, threads, band_};
  for (std::uint32_t changing = 0; changing < 2; ++changing) {
    const std::uint32_t bothPlanes[] = {threads, rowsPerGroup_, band_, 2, changing};
    const std::uint32_t onePlane[] = {threads, rowsPerGroup_, band_, 1, changing};
    PELAGIC_TRY(rows, gpu::ComputePass::create(context, {"waves evolve rows", shaders::waves_rows, rowBindings,
                                                         sizeof(shader::WaveRowsPush), bothPlanes}));
    PELAGIC_TRY(foamRows, gpu::ComputePass::create(context, {"waves foam rows", shaders::waves_rows, rowBindings,
                                                             sizeof(shader::WaveRowsPush), onePlane}));
    rows_[changing] = std::move(rows);
    foamRows_[changing] = std::move(foamRows);
  }
  PELAGIC_TRY(columns, gpu::ComputePass::create(context, {"waves columns", shaders::waves_columns, columnBindings,
                                                          sizeof(shader::WaveColumnsPush), column}));
  PELAGIC_TRY(foam, gpu::ComputePass::create(context, {"waves foam", shaders::waves_foam, foamBindings,
                                                       sizeof(shader::WaveFoamPush), column}));
  columns_ = std::move(columns);
  foam_ = std::move(foam);
  return {};
}

Result<void> WaveTransform::createSets(const WaveImages& images) {
  // The row passes have one layout, so that one set fits them all.
  PELAGIC_TRY(rows, rows_[0].createSet("waves rows"));
  rows.texelBuffer(0, *amplitudesView_);
  rows.texelBuffer(1, *constantsView_);
  rows.buffer(2, cascades_.handle());
  rows.buffer(3, planes_.handle());
  rowsSet_ = std::move(rows);
  for (std::uint32_t newest = 0; newest < 2; ++newest) {
    for (std::uint32_t target = 0; target < 2; ++target) {
      PELAGIC_TRY(set, columns_.createSet("waves columns"));
      set.texelBuffer(0, *planesView_);
      set.buffer(1, cascades_.handle());
      set.buffer(2, history_[newest].handle());
      set.storageImage(3, images.displacement[target].mipView(0));
      set.storageImage(4, images.gradient.mipView(0));
      set.storageImage(5, images.moments.mipView(0));
      set.storageImage(6, images.foam.mipView(0));
      columnsSets_[target][newest] = std::move(set);
    }
    PELAGIC_TRY(set, foam_.createSet("waves foam"));
    set.texelBuffer(0, *planesView_);
    set.buffer(1, cascades_.handle());
    set.buffer(2, history_[newest].handle());
    set.buffer(3, history_[1 - newest].handle());
    foamSets_[newest] = std::move(set);
  }
  return {};
}

void WaveTransform::upload(vk::CommandBuffer commands, const SeaChange& sea, std::uint32_t slot) noexcept {
  const gpu::Buffer& staging = staging_[slot];
  auto* bytes = static_cast<std::byte*>(staging.mapped());
  vk::DeviceSize offset = 0;
  // The sea that comes, and behind it the one that goes.
  const auto copy = [&](const gpu::Buffer& target, const auto& after, const auto& before) {
    const vk::DeviceSize half = target.size() / 2;
    std::memcpy(bytes + offset, after.data(), half);
    if (!before.empty()) std::memcpy(bytes + offset + half, before.data(), half);
    commands.copyBuffer(staging.handle(), target.handle(),
                        vk::BufferCopy(offset, 0, before.empty() ? half : target.size()), context_->dispatch);
    offset += target.size();
  };
  gpu::Barrier()
      .buffer(cascades_, gpu::kTransferWrite)
      .buffer(amplitudes_, gpu::kTransferWrite)
      .buffer(constants_, gpu::kTransferWrite)
      .record(*context_, commands);
  copy(cascades_, sea.after.cascades, sea.before.cascades);
  copy(amplitudes_, sea.after.amplitudes, sea.before.amplitudes);
  copy(constants_, sea.after.constants, sea.before.constants);
  gpu::Barrier()
      .buffer(cascades_, gpu::kComputeRead)
      .buffer(amplitudes_, gpu::kComputeTexelRead)
      .buffer(constants_, gpu::kComputeTexelRead)
      .record(*context_, commands);
}

void WaveTransform::recordRowPass(vk::CommandBuffer commands, const gpu::ComputePass& pass, std::uint32_t cascades,
                                  const SeaMoment& moment) noexcept {
  gpu::Barrier().buffer(planes_, gpu::kComputeWrite).record(*context_, commands);
  pass.bind(commands, rowsSet_);
  pass.push(commands, shader::WaveRowsPush{static_cast<std::uint32_t>(moment.fraction >> 32),
                                           static_cast<std::uint32_t>(moment.fraction), moment.share});
  pass.dispatch(commands, 1, gpu::groups(2 * band_, rowsPerGroup_), cascades);
  gpu::Barrier().buffer(planes_, gpu::kComputeTexelRead).record(*context_, commands);
}

void WaveTransform::recordFoamTick(vk::CommandBuffer commands, const SeaMoment& moment, bool keep) noexcept {
  recordRowPass(commands, foamRows_[moment.changing], foamCascades_, moment);
  gpu::Buffer& after = history_[1 - newest_];
  gpu::Barrier()
      .buffer(history_[newest_], gpu::kComputeRead)
      .buffer(after, gpu::kComputeWrite)
      .record(*context_, commands);
  foam_.bind(commands, foamSets_[newest_]);
  foam_.push(commands, shader::WaveFoamPush{keep ? 1u : 0u, moment.share});
  foam_.dispatch(commands, size_ / columnsPerGroup_, 1, foamCascades_);
  gpu::Barrier().buffer(after, gpu::kComputeRead).record(*context_, commands);
  newest_ = 1 - newest_;
}

void WaveTransform::recordRows(vk::CommandBuffer commands, const SeaMoment& moment) noexcept {
  recordRowPass(commands, rows_[moment.changing], count_, moment);
}

void WaveTransform::recordColumns(vk::CommandBuffer commands, const SeaMoment& moment, std::uint32_t target,
                                  float fade) noexcept {
  columns_.bind(commands, columnsSets_[target][newest_]);
  columns_.push(commands, shader::WaveColumnsPush{foamCascades_, fade, moment.share});
  columns_.dispatch(commands, size_ / columnsPerGroup_, 1, count_);
}

}  // namespace pelagic
