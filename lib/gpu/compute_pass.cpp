#include <algorithm>
#include <gpu/compute_pass.hpp>
#include <numeric>
#include <string>

namespace pelagic::gpu {

vk::DescriptorType DescriptorSet::typeOf(std::uint32_t binding) const {
  return std::find_if(bindings_.begin(), bindings_.end(), [&](const Binding& b) { return b.index == binding; })->type;
}

void DescriptorSet::buffer(std::uint32_t binding, vk::Buffer buffer, vk::DeviceSize offset, vk::DeviceSize range) {
  const vk::DescriptorBufferInfo info(buffer, offset, range);
  context_->device.updateDescriptorSets(vk::WriteDescriptorSet(set_, binding, 0, typeOf(binding), nullptr, info), {},
                                        context_->dispatch);
}

void DescriptorSet::storageImage(std::uint32_t binding, vk::ImageView view, std::uint32_t element) {
  const vk::DescriptorImageInfo info({}, view, vk::ImageLayout::eGeneral);
  context_->device.updateDescriptorSets(vk::WriteDescriptorSet(set_, binding, element, typeOf(binding), info), {},
                                        context_->dispatch);
}

void DescriptorSet::sampled(std::uint32_t binding, vk::ImageView view, vk::Sampler sampler, std::uint32_t element,
                            vk::ImageLayout layout) {
  const vk::DescriptorImageInfo info(sampler, view, layout);
  context_->device.updateDescriptorSets(vk::WriteDescriptorSet(set_, binding, element, typeOf(binding), info), {},
                                        context_->dispatch);
}

void DescriptorSet::texelBuffer(std::uint32_t binding, vk::BufferView view) {
  context_->device.updateDescriptorSets(
      vk::WriteDescriptorSet(set_, binding, 0, typeOf(binding), nullptr, nullptr, view), {}, context_->dispatch);
}

Result<DescriptorLayout> DescriptorLayout::create(Context& context, std::string_view name,
                                                  std::span<const Binding> bindings, vk::ShaderStageFlags stages) {
  DescriptorLayout result;
  result.context_ = &context;
  result.bindings_.assign(bindings.begin(), bindings.end());
  std::vector<vk::DescriptorSetLayoutBinding> entries;
  for (const Binding& b : bindings) entries.emplace_back(b.index, b.type, b.count, stages);
  auto layout = context.device.createDescriptorSetLayoutUnique(vk::DescriptorSetLayoutCreateInfo({}, entries),
                                                               context.allocator(), context.dispatch);
  if (layout.result != vk::Result::eSuccess) {
    return fail(layout.result, "create the descriptor set layout of " + std::string(name));
  }
  result.layout_ = std::move(layout.value);
  context.name(*result.layout_, name);
  return result;
}

Result<DescriptorSet> DescriptorLayout::createSet(std::string_view name) const {
  DescriptorSet result;
  result.context_ = context_;
  result.bindings_ = bindings_;
  std::vector<vk::DescriptorPoolSize> sizes;
  for (const Binding& b : bindings_) sizes.emplace_back(b.type, b.count);
  auto pool = context_->device.createDescriptorPoolUnique(vk::DescriptorPoolCreateInfo({}, 1, sizes),
                                                          context_->allocator(), context_->dispatch);
  if (pool.result != vk::Result::eSuccess)
    return fail(pool.result, "create a descriptor pool for " + std::string(name));
  result.pool_ = std::move(pool.value);
  context_->name(*result.pool_, name);
  auto sets = context_->device.allocateDescriptorSets(vk::DescriptorSetAllocateInfo(*result.pool_, *layout_),
                                                      context_->dispatch);
  if (sets.result != vk::Result::eSuccess)
    return fail(sets.result, "allocate a descriptor set for " + std::string(name));
  result.set_ = sets.value.front();
  context_->name(result.set_, name);
  return result;
}

Result<Unique<vk::ShaderModule>> createShader(Context& context, std::string_view name,
                                              std::span<const std::uint32_t> code) {
  const vk::ShaderModuleCreateInfo info({}, code.size_bytes(), code.data());
  auto shader = context.device.createShaderModuleUnique(info, context.allocator(), context.dispatch);
  if (shader.result != vk::Result::eSuccess) {
    return fail(shader.result, "create the shader module " + std::string(name));
  }
  context.name(*shader.value, name);
  return std::move(shader.value);
}

namespace {

Result<std::shared_ptr<const CompiledPass>> compile(Context& context, const ComputePassInfo& info) {
  auto result = std::make_shared<CompiledPass>();
  PELAGIC_TRY(descriptors,
              DescriptorLayout::create(context, info.name, info.bindings, vk::ShaderStageFlagBits::eCompute));
  result->descriptors = std::move(descriptors);

  const vk::DescriptorSetLayout setLayout = result->descriptors.handle();
  const vk::PushConstantRange push(vk::ShaderStageFlagBits::eCompute, 0, info.pushBytes);
  vk::PipelineLayoutCreateInfo layoutInfo({}, setLayout);
  if (info.pushBytes > 0) layoutInfo.setPushConstantRanges(push);
  auto layout = context.device.createPipelineLayoutUnique(layoutInfo, context.allocator(), context.dispatch);
  if (layout.result != vk::Result::eSuccess) {
    return fail(layout.result, "create the pipeline layout of " + std::string(info.name));
  }
  result->layout = std::move(layout.value);
  context.name(*result->layout, info.name);

  PELAGIC_TRY(shader, createShader(context, info.name, info.code));
  std::vector<vk::SpecializationMapEntry> entries;
  for (std::uint32_t i = 0; i < info.constants.size(); ++i) entries.emplace_back(i, i * 4, 4);
  const vk::SpecializationInfo constants(static_cast<std::uint32_t>(entries.size()), entries.data(),
                                         info.constants.size_bytes(), info.constants.data());
  const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *shader, "main", &constants);
  auto pipeline = context.device.createComputePipelineUnique(context.pipelineCache,
                                                             vk::ComputePipelineCreateInfo({}, stage, *result->layout),
                                                             context.allocator(), context.dispatch);
  if (pipeline.result != vk::Result::eSuccess) {
    return fail(pipeline.result, "create the pipeline " + std::string(info.name));
  }
  result->pipeline = std::move(pipeline.value);
  context.name(*result->pipeline, info.name);
  return result;
}

}  // namespace

Result<ComputePass> ComputePass::create(Context& context, const ComputePassInfo& info) {
  std::vector<std::uint32_t> specialisation{info.pushBytes};
  for (const Binding& b : info.bindings) {
    specialisation.insert(specialisation.end(), {b.index, static_cast<std::uint32_t>(b.type), b.count});
  }
  specialisation.insert(specialisation.end(), info.constants.begin(), info.constants.end());
  const auto key = std::pair(info.code.data(), std::move(specialisation));
  auto found = context.passes.find(key);
  if (found == context.passes.end()) {
    PELAGIC_TRY(compiled, compile(context, info));
    found = context.passes.emplace(key, std::move(compiled)).first;
  }
  ComputePass result;
  result.context_ = &context;
  result.compiled_ = found->second;
  return result;
}

void ComputePass::bind(vk::CommandBuffer commands, const DescriptorSet& set) const noexcept {
  commands.bindPipeline(vk::PipelineBindPoint::eCompute, *compiled_->pipeline, context_->dispatch);
  const vk::DescriptorSet handle = set.handle();
  commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *compiled_->layout, 0, 1, &handle, 0, nullptr,
                              context_->dispatch);
}

}  // namespace pelagic::gpu
