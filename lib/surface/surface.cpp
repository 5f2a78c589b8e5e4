#include <surface/surface_frame.h>
#include <cstring>
#include <gpu/field.hpp>
#include <surface/surface_impl.hpp>
#include <surface_frag.spv.hpp>
#include <surface_motion_frag.spv.hpp>
#include <surface_motion_vert.spv.hpp>
#include <surface_select_blocks_comp.spv.hpp>
#include <surface_tessellate_comp.spv.hpp>
#include <surface_vert.spv.hpp>

namespace pelagic {
namespace surface {
namespace {

using shader::kBlockCells;
using shader::kBlockSide;

Result<gpu::Buffer> createIndices(gpu::Context& context) {
  std::array<std::uint16_t, shader::kBlockIndices> indices{};
  std::size_t next = 0;
  for (std::uint32_t row = 0; row < kBlockCells; ++row) {
    for (std::uint32_t column = 0; column < kBlockCells; ++column) {
      const std::uint32_t corner = row * kBlockSide + column;
      for (const std::uint32_t vertex :
           {corner, corner + 1, corner + kBlockSide, corner + 1, corner + kBlockSide + 1, corner + kBlockSide}) {
        indices[next++] = static_cast<std::uint16_t>(vertex);
      }
    }
  }
  PELAGIC_TRY(buffer, gpu::Buffer::create(context, Stage::surface, "surface block indices", sizeof(indices),
                                          vk::BufferUsageFlagBits::eIndexBuffer, gpu::Buffer::Placement::upload));
  std::memcpy(buffer.mapped(), indices.data(), sizeof(indices));
  return buffer;
}

Result<gpu::ComputePass> createTessellate(gpu::Context& context, bool motion, bool gain) {
  using Type = vk::DescriptorType;
  const gpu::Binding bindings[] = {{tFrame, Type::eStorageBuffer},
                                   {tRows, Type::eStorageBuffer},
                                   {tDisplacement, Type::eCombinedImageSampler},
                                   {tPrevious, Type::eCombinedImageSampler},
                                   {tVertices, Type::eStorageBuffer},
                                   {tFlags, Type::eStorageBuffer},
                                   {tGain, Type::eCombinedImageSampler}};
  const std::uint32_t constants[] = {motion, gain};
  gpu::ComputePassInfo info;
  info.name = "surface tessellate";
  info.code = shaders::surface_tessellate_comp;
  info.bindings = bindings;
  info.constants = constants;
  return gpu::ComputePass::create(context, info);
}

Result<gpu::ComputePass> createSelect(gpu::Context& context) {
  using Type = vk::DescriptorType;
  const gpu::Binding bindings[] = {{sFlags, Type::eStorageBuffer},
                                   {sVisible, Type::eStorageBuffer},
                                   {sArguments, Type::eStorageBuffer},
                                   {sFrame, Type::eStorageBuffer}};
  gpu::ComputePassInfo info;
  info.name = "surface select blocks";
  info.code = shaders::surface_select_blocks_comp;
  info.bindings = bindings;
  return gpu::ComputePass::create(context, info);
}

Result<gpu::Unique<vk::PipelineLayout>> createDrawLayout(gpu::Context& context, vk::DescriptorSetLayout set) {
  auto layout = context.device.createPipelineLayoutUnique(vk::PipelineLayoutCreateInfo({}, set), context.allocator(),
                                                          context.dispatch);
  if (layout.result != vk::Result::eSuccess)
    return gpu::fail(layout.result, "create the pipeline layout of surface draw");
  context.name(*layout.value, "surface draw");
  return std::move(layout.value);
}

/// Both faces are drawn: which way the host's y points is not known, and the sea has an underside.
Result<gpu::Unique<vk::Pipeline>> createDraw(gpu::Context& context, vk::PipelineLayout layout, bool motion,
                                             bool reversedDepth) {
  PELAGIC_TRY(vertex, gpu::createShader(context, "surface vertex",
                                        motion ? shaders::surface_motion_vert : shaders::surface_vert));
  PELAGIC_TRY(fragment, gpu::createShader(context, "surface fragment",
                                          motion ? shaders::surface_motion_frag : shaders::surface_frag));
  using ShaderStage = vk::ShaderStageFlagBits;
  const std::array<vk::PipelineShaderStageCreateInfo, 2> stages{
      {{{}, ShaderStage::eVertex, *vertex, "main"}, {{}, ShaderStage::eFragment, *fragment, "main"}}};
  const vk::PipelineVertexInputStateCreateInfo input;
  const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::eTriangleList);
  const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
  vk::PipelineRasterizationStateCreateInfo raster;
  raster.depthClampEnable = VK_TRUE;  // a finite far plane must not cut the sea
  raster.polygonMode = vk::PolygonMode::eFill;
  raster.cullMode = vk::CullModeFlagBits::eNone;
  raster.lineWidth = 1;
  const vk::PipelineMultisampleStateCreateInfo samples({}, vk::SampleCountFlagBits::e1);
  // Equal passes, so that water clamped to the far plane is drawn.
  const vk::PipelineDepthStencilStateCreateInfo depth(
      {}, VK_TRUE, VK_TRUE, reversedDepth ? vk::CompareOp::eGreaterOrEqual : vk::CompareOp::eLessOrEqual);
  using Channel = vk::ColorComponentFlagBits;
  std::array<vk::PipelineColorBlendAttachmentState, 3> blends;
  for (auto& state : blends) state.colorWriteMask = Channel::eR | Channel::eG | Channel::eB | Channel::eA;
  const std::uint32_t attachments = motion ? 3 : 2;
  const vk::PipelineColorBlendStateCreateInfo blend({}, VK_FALSE, vk::LogicOp::eCopy, attachments, blends.data());
  const std::array<vk::DynamicState, 2> dynamicStates{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
  const vk::PipelineDynamicStateCreateInfo dynamic({}, dynamicStates);
  const std::array<vk::Format, 3> formats{kPositionFormat, kBodyFormat, kMotionFormat};
  const vk::PipelineRenderingCreateInfo rendering(0, attachments, formats.data(), kDepthFormat);
  const vk::GraphicsPipelineCreateInfo info({}, stages, &input, &assembly, nullptr, &viewport, &raster, &samples,
                                            &depth, &blend, &dynamic, layout, nullptr, 0, nullptr, -1, &rendering);
  auto pipeline =
      context.device.createGraphicsPipelineUnique(context.pipelineCache, info, context.allocator(), context.dispatch);
  if (pipeline.result != vk::Result::eSuccess) return gpu::fail(pipeline.result, "create the pipeline surface draw");
  context.name(*pipeline.value, reversedDepth ? "surface draw reversed" : "surface draw");
  return std::move(pipeline.value);
}

}  // namespace
}  // namespace surface

Result<const gpu::ComputePass*> Surface::Impl::tessellateWith(bool gain) {
  auto& pass = tessellate[gain];
  if (!pass) {
    PELAGIC_TRY(created, surface::createTessellate(*context, info.motionVectors, gain));
    pass = std::move(created);
  }
  return &*pass;
}

Surface::Surface(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
Surface::Surface(Surface&&) noexcept = default;
Surface& Surface::operator=(Surface&&) noexcept = default;
Surface::~Surface() = default;

Result<Surface> Surface::create(Device& device, const SurfaceInfo& info) {
  PELAGIC_CHECK(gpu::check(
      "SurfaceInfo::", {{"targetEdge", info.targetEdge, 2, 64, "2 to 64 px"},
                        {"planetRadius", info.planetRadius, kLeastPlanetRadius, kMostPlanetRadius, "1e5 to 1e8 m"}}));
  gpu::Context& context = device.context();
  auto impl = std::make_unique<Impl>();
  impl->context = &context;
  impl->info = info;
  PELAGIC_TRY(sampler, gpu::createSampler(context, "surface displacement", {}));
  impl->sampler = std::move(sampler);
  PELAGIC_TRY(nearest, gpu::createSampler(context, "surface gain", {vk::Filter::eNearest}));
  impl->nearest = std::move(nearest);
  PELAGIC_CHECK(impl->tessellateWith(false));
  PELAGIC_TRY(select, surface::createSelect(context));
  impl->select = std::move(select);
  const gpu::Binding bindings[] = {{surface::dFrame, vk::DescriptorType::eUniformBuffer},
                                   {surface::dVertices, vk::DescriptorType::eStorageBuffer},
                                   {surface::dVisible, vk::DescriptorType::eStorageBuffer}};
  PELAGIC_TRY(descriptors,
              gpu::DescriptorLayout::create(context, "surface draw", bindings,
                                            vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment));
  impl->drawDescriptors = std::move(descriptors);
  PELAGIC_TRY(layout, surface::createDrawLayout(context, impl->drawDescriptors.handle()));
  impl->drawLayout = std::move(layout);
  for (const bool reversed : {false, true}) {
    PELAGIC_TRY(draw, surface::createDraw(context, *impl->drawLayout, info.motionVectors, reversed));
    impl->draw[reversed] = std::move(draw);
  }
  PELAGIC_TRY(indices, surface::createIndices(context));
  impl->indices = std::move(indices);
  return Surface(std::move(impl));
}

}  // namespace pelagic
