#include <surface/surface_frame.h>
#include <algorithm>
#include <gpu/barrier.hpp>
#include <pelagic/wave_sampling.hpp>
#include <surface/projector.hpp>
#include <surface/surface_impl.hpp>
#include <vector>

namespace pelagic {
namespace surface {
namespace {

constexpr std::uint32_t kMaxExtent = 16384;
/// vkCmdUpdateBuffer's limit [bytes].
constexpr vk::DeviceSize kMaxUpdate = 65536;

constexpr ImageState kColorWrite{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                 VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
constexpr ImageState kDepthWrite{
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
    VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL};
constexpr gpu::BufferState kVertexRead{vk::PipelineStageFlagBits2::eVertexShader,
                                       vk::AccessFlagBits2::eShaderStorageRead};
constexpr gpu::BufferState kFrameRead{vk::PipelineStageFlagBits2::eComputeShader |
                                          vk::PipelineStageFlagBits2::eVertexShader |
                                          vk::PipelineStageFlagBits2::eFragmentShader,
                                      vk::AccessFlagBits2::eShaderStorageRead | vk::AccessFlagBits2::eUniformRead};

/// Multiples of the standard deviation that no crest is expected to exceed.
constexpr double kCrest = 6;

Relief reliefOf(const WaveMaps& maps, double planetRadius) noexcept {
  return {maps.elevationDeviation, kCrest * maps.elevationDeviation, kCrest * maps.horizontalDeviation, planetRadius};
}

}  // namespace
}  // namespace surface

struct SurfaceView::Impl {
  Surface::Impl* surface = nullptr;
  const gpu::ComputePass* tessellatePass = nullptr;
  VkExtent2D extent{};
  std::array<VkImageView, 2> displacementViews{};
  surface::GridLimits limits;
  double cellEdge = 0;  ///< As recorded last, or as asked for [px].
  std::vector<glm::vec2> rows;
  shader::SurfaceFrame frame{};
  glm::dvec3 previousPosition{0};
  bool hasPrevious = false;

  gpu::Image position, motion, body, depth;
  gpu::Buffer frameBuffer, rowBuffer, vertices, flags, visible, arguments;
  /// [2 * current + previous] of the displacement pair.
  std::array<gpu::DescriptorSet, 4> tessellateSets;
  gpu::DescriptorSet selectSet;
  gpu::DescriptorSet drawSet;

  Result<void> createImages();
  Result<void> createBuffers();
  Result<void> createSets(const WaveMaps& maps);
  surface::Grid prepare(const WaveMaps& maps, const Camera& camera) noexcept;
  void upload(vk::CommandBuffer commands, const surface::Grid& grid) noexcept;
  void tessellate(vk::CommandBuffer commands, const WaveMaps& maps, const surface::Grid& grid) noexcept;
  void draw(vk::CommandBuffer commands, bool reversedDepth) noexcept;
};

Result<void> SurfaceView::Impl::createImages() {
  using Usage = vk::ImageUsageFlagBits;
  struct Target {
    gpu::Image* image;
    vk::Format format;
    vk::ImageUsageFlagBits attachment;
    const char* name;
  };
  const Target targets[] = {{&position, surface::kPositionFormat, Usage::eColorAttachment, "water position"},
                            {&motion, surface::kMotionFormat, Usage::eColorAttachment, "water motion"},
                            {&body, surface::kBodyFormat, Usage::eColorAttachment, "water body"},
                            {&depth, surface::kDepthFormat, Usage::eDepthStencilAttachment, "water depth"}};
  for (const Target& target : targets) {
    if (target.image == &motion && !surface->info.motionVectors) continue;
    gpu::ImageInfo info;
    info.format = target.format;
    info.extent = extent;
    info.usage = target.attachment | Usage::eSampled | Usage::eTransferSrc;
    PELAGIC_TRY(image, gpu::Image::create(*surface->context, Stage::surface, target.name, info));
    *target.image = std::move(image);
  }
  return {};
}

Result<void> SurfaceView::Impl::createBuffers() {
  using Usage = vk::BufferUsageFlagBits;
  struct Part {
    gpu::Buffer* buffer;
    const char* name;
    vk::DeviceSize size;
    vk::BufferUsageFlags usage;
  };
  const vk::DeviceSize vertexBytes = vk::DeviceSize(limits.blocks) * shader::kBlockVertices * 2 * sizeof(glm::vec4);
  const Part parts[] = {
      {&frameBuffer, "surface frame", sizeof(shader::SurfaceFrame),
       Usage::eUniformBuffer | Usage::eStorageBuffer | Usage::eTransferDst},
      {&rowBuffer, "surface rows", limits.rows * sizeof(glm::vec2), Usage::eStorageBuffer | Usage::eTransferDst},
      {&vertices, "surface vertices", vertexBytes, Usage::eStorageBuffer},
      {&flags, "surface block flags", limits.blocks * sizeof(std::uint32_t), Usage::eStorageBuffer},
      {&visible, "surface visible blocks", limits.blocks * sizeof(std::uint32_t), Usage::eStorageBuffer},
      {&arguments, "surface draw arguments", sizeof(VkDrawIndexedIndirectCommand),
       Usage::eStorageBuffer | Usage::eIndirectBuffer | Usage::eTransferSrc}};
  if (vertexBytes > surface->context->properties.limits.maxStorageBufferRange) {
    return gpu::reject("the extent " + std::to_string(extent.width) + " x " + std::to_string(extent.height) +
                           " needs " + std::to_string(vertexBytes) +
                           " bytes of vertices, more than the device's maxStorageBufferRange",
                       ErrorCode::unsupported);
  }
  for (const Part& part : parts) {
    PELAGIC_TRY(buffer, gpu::Buffer::create(*surface->context, Stage::surface, part.name, part.size, part.usage));
    *part.buffer = std::move(buffer);
  }
  rows.resize(limits.rows);
  return {};
}

Result<void> SurfaceView::Impl::createSets(const WaveMaps& maps) {
  for (std::size_t i = 0; i < 2; ++i) {
    displacementViews[i] = maps.displacementPair[i].view;
    if (displacementViews[i] == VK_NULL_HANDLE) {
      return gpu::reject("WaveMaps::displacementPair[" + std::to_string(i) + "].view is null");
    }
  }
  PELAGIC_TRY(pass, surface->tessellateWith(maps.gain.view != VK_NULL_HANDLE));
  tessellatePass = pass;
  for (std::size_t i = 0; i < 4; ++i) {
    PELAGIC_TRY(set, pass->createSet("surface tessellate " + std::to_string(i)));
    set.buffer(surface::tFrame, frameBuffer.handle());
    set.buffer(surface::tRows, rowBuffer.handle());
    set.sampled(surface::tDisplacement, displacementViews[i / 2], *surface->sampler);
    set.sampled(surface::tPrevious, displacementViews[i % 2], *surface->sampler);
    set.buffer(surface::tVertices, vertices.handle());
    set.buffer(surface::tFlags, flags.handle());
    // What is missing is bound to what is there: the shader's constant keeps it untouched.
    set.sampled(surface::tGain, maps.gain.view ? maps.gain.view : displacementViews[0], *surface->nearest);
    tessellateSets[i] = std::move(set);
  }
  PELAGIC_TRY(select, surface->select.createSet("surface select blocks"));
  select.buffer(surface::sFlags, flags.handle());
  select.buffer(surface::sVisible, visible.handle());
  select.buffer(surface::sArguments, arguments.handle());
  select.buffer(surface::sFrame, frameBuffer.handle());
  selectSet = std::move(select);
  PELAGIC_TRY(draw, surface->drawDescriptors.createSet("surface draw"));
  draw.buffer(surface::dFrame, frameBuffer.handle());
  draw.buffer(surface::dVertices, vertices.handle());
  draw.buffer(surface::dVisible, visible.handle());
  drawSet = std::move(draw);
  return {};
}

/// Lays out the grid and fills `frame`.
surface::Grid SurfaceView::Impl::prepare(const WaveMaps& maps, const Camera& camera) noexcept {
  const surface::Relief relief = surface::reliefOf(maps, surface->info.planetRadius);
  const auto grid =
      surface::projectGrid(camera, extent, static_cast<double>(surface->info.targetEdge), relief, limits, rows);
  cellEdge = grid.edge;
  const glm::mat4 clip = camera.projection * glm::mat4(camera.rotation);
  const glm::dvec3 moved = hasPrevious ? camera.position - previousPosition : glm::dvec3(0);
  frame.previousClip = hasPrevious ? frame.clip : clip;
  frame.clip = clip;
  frame.axes = glm::vec4(glm::vec2(grid.right), glm::vec2(grid.forward));
  frame.previousOffset = glm::vec4(glm::dvec4(moved, surface->info.planetRadius));
  frame.firstColumn = static_cast<float>(grid.firstColumn);
  frame.columnStep = static_cast<float>(grid.columnStep);
  frame.radius = static_cast<float>(grid.radius);
  frame.cameraHeight = static_cast<float>(camera.position.y);
  frame.inverseExtent = 1.0f / glm::vec2(extent.width, extent.height);
  frame.motionScale = hasPrevious ? 1.0f : 0.0f;
  frame.blocks = grid.columnBlocks * grid.rowBlocks;
  frame.waves = waveSampling(maps, {camera.position.x, camera.position.z});
  previousPosition = camera.position;
  hasPrevious = true;
  return grid;
}

void SurfaceView::Impl::upload(vk::CommandBuffer commands, const surface::Grid& grid) noexcept {
  const auto& dispatch = surface->context->dispatch;
  gpu::Barrier()
      .buffer(frameBuffer, gpu::kTransferWrite)
      .buffer(rowBuffer, gpu::kTransferWrite)
      .record(*surface->context, commands);
  commands.updateBuffer(frameBuffer.handle(), 0, sizeof(frame), &frame, dispatch);
  const vk::DeviceSize bytes =
      grid.columnBlocks == 0 ? 0 : (grid.rowBlocks * shader::kBlockCells + 1) * sizeof(glm::vec2);
  for (vk::DeviceSize at = 0; at < bytes; at += surface::kMaxUpdate) {
    commands.updateBuffer(rowBuffer.handle(), at, std::min(bytes - at, surface::kMaxUpdate),
                          reinterpret_cast<const std::byte*>(rows.data()) + at, dispatch);
  }
}

void SurfaceView::Impl::tessellate(vk::CommandBuffer commands, const WaveMaps& maps,
                                   const surface::Grid& grid) noexcept {
  gpu::Barrier()
      .buffer(frameBuffer, surface::kFrameRead)
      .buffer(rowBuffer, gpu::kComputeRead)
      .buffer(vertices, gpu::kComputeWrite)
      .buffer(flags, gpu::kComputeWrite)
      .buffer(visible, gpu::kComputeWrite)
      .buffer(arguments, gpu::kComputeWrite)
      .record(*surface->context, commands);
  if (grid.columnBlocks > 0) {
    const std::size_t current = maps.displacement.view == displacementViews[1] ? 1 : 0;
    const std::size_t previous = maps.previousDisplacement.view == displacementViews[1] ? 1 : 0;
    tessellatePass->bind(commands, tessellateSets[2 * current + previous]);
    tessellatePass->dispatch(commands, grid.columnBlocks, grid.rowBlocks);
  }
  gpu::Barrier().buffer(flags, gpu::kComputeRead).record(*surface->context, commands);
  surface->select.bind(commands, selectSet);
  surface->select.dispatch(commands, 1);
}

void SurfaceView::Impl::draw(vk::CommandBuffer commands, bool reversedDepth) noexcept {
  const auto& dispatch = surface->context->dispatch;
  gpu::Barrier before, after;
  before.buffer(vertices, surface::kVertexRead)
      .buffer(visible, surface::kVertexRead)
      .buffer(arguments, gpu::kIndirectRead)
      .image(position, surface::kColorWrite, true)
      .image(body, surface::kColorWrite, true)
      .image(depth, surface::kDepthWrite, true);
  if (surface->info.motionVectors) before.image(motion, surface::kColorWrite, true);
  before.record(*surface->context, commands);

  const auto attachment = [](const gpu::Image& image, vk::AttachmentLoadOp load, const vk::ClearValue& clear) {
    const bool isDepth = image.info().format == surface::kDepthFormat;
    return vk::RenderingAttachmentInfo(
        image.view(), isDepth ? vk::ImageLayout::eDepthAttachmentOptimal : vk::ImageLayout::eColorAttachmentOptimal, {},
        {}, {}, load, vk::AttachmentStoreOp::eStore, clear);
  };
  std::array<vk::RenderingAttachmentInfo, 3> colors{
      attachment(position, vk::AttachmentLoadOp::eDontCare, {}),
      attachment(body, vk::AttachmentLoadOp::eClear, vk::ClearColorValue(std::array<std::uint32_t, 4>{0, 0, 0, 0}))};
  if (surface->info.motionVectors) colors[2] = attachment(motion, vk::AttachmentLoadOp::eDontCare, {});
  const auto depthAttachment =
      attachment(depth, vk::AttachmentLoadOp::eClear, vk::ClearDepthStencilValue(reversedDepth ? 0.0f : 1.0f, 0));
  const vk::Rect2D area({}, extent);
  commands.beginRendering(
      vk::RenderingInfo({}, area, 1, 0, surface->info.motionVectors ? 3 : 2, colors.data(), &depthAttachment),
      dispatch);
  commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *surface->draw[reversedDepth], dispatch);
  const vk::Viewport viewport(0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height), 0, 1);
  commands.setViewport(0, 1, &viewport, dispatch);
  commands.setScissor(0, 1, &area, dispatch);
  const vk::DescriptorSet set = drawSet.handle();
  commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *surface->drawLayout, 0, 1, &set, 0, nullptr, dispatch);
  commands.bindIndexBuffer(surface->indices.handle(), 0, vk::IndexType::eUint16, dispatch);
  commands.drawIndexedIndirect(arguments.handle(), 0, 1, sizeof(VkDrawIndexedIndirectCommand), dispatch);
  commands.endRendering(dispatch);

  after.image(position, kShaderRead).image(body, kShaderRead).image(depth, kShaderRead);
  if (surface->info.motionVectors) after.image(motion, kShaderRead);
  after.record(*surface->context, commands);
}

SurfaceView::SurfaceView(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
SurfaceView::SurfaceView(SurfaceView&&) noexcept = default;
SurfaceView& SurfaceView::operator=(SurfaceView&&) noexcept = default;
SurfaceView::~SurfaceView() = default;

Result<SurfaceView> SurfaceView::create(Surface& surface, const WaveMaps& maps, VkExtent2D extent) {
  const auto outside = [](std::uint32_t side) { return side < 1 || side > surface::kMaxExtent; };
  if (outside(extent.width) || outside(extent.height)) {
    return gpu::reject("the surface view's extent is " + std::to_string(extent.width) + " x " +
                       std::to_string(extent.height) + " px, each side must lie within 1 and 16384");
  }
  auto impl = std::make_unique<Impl>();
  impl->surface = surface.impl_.get();
  impl->extent = extent;
  impl->cellEdge = static_cast<double>(surface.impl_->info.targetEdge);
  impl->limits = surface::limitsOf(extent, impl->cellEdge);
  PELAGIC_CHECK(impl->createImages());
  PELAGIC_CHECK(impl->createBuffers());
  PELAGIC_CHECK(impl->createSets(maps));
  return SurfaceView(std::move(impl));
}

void SurfaceView::record(VkCommandBuffer commands, const WaveMaps& maps, const Camera& camera,
                         Timings* timings) noexcept {
  const vk::CommandBuffer buffer(commands);
  const surface::Grid grid = impl_->prepare(maps, camera);
  if (timings) timings->begin(commands, "surface tessellate");
  impl_->upload(buffer, grid);
  impl_->tessellate(buffer, maps, grid);
  if (timings) timings->end(commands);
  if (timings) timings->begin(commands, "surface draw");
  impl_->draw(buffer, camera.reversedDepth);
  if (timings) timings->end(commands);
}

WaterBuffer SurfaceView::buffer() const noexcept {
  return {impl_->position.map(),
          impl_->surface->info.motionVectors ? impl_->motion.map() : MapView{},
          impl_->body.map(),
          impl_->depth.map(),
          impl_->surface->info.planetRadius,
          static_cast<float>(impl_->cellEdge)};
}

VkBuffer SurfaceView::drawArguments() const noexcept { return impl_->arguments.handle(); }

}  // namespace pelagic
