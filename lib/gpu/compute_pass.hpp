/// A compute pipeline with its layout.
#pragma once

#include <gpu/descriptors.hpp>

namespace pelagic::gpu {

struct ComputePassInfo {
  std::string_view name;
  std::span<const std::uint32_t> code;  ///< Of static storage: its address stands for it.
  std::span<const Binding> bindings;
  std::uint32_t pushBytes = 0;  ///< At most 128, the least that Vulkan guarantees.
  /// Specialisation constants 0, 1, 2 …, 4 bytes each.
  std::span<const std::uint32_t> constants;
};

struct CompiledPass {
  DescriptorLayout descriptors;
  Unique<vk::PipelineLayout> layout;
  Unique<vk::Pipeline> pipeline;
};

class ComputePass {
 public:
  /// Compiles it, or finds what was compiled for another.
  static Result<ComputePass> create(Context& context, const ComputePassInfo& info);
  Result<DescriptorSet> createSet(std::string_view name) const { return compiled_->descriptors.createSet(name); }

  /// Binds pipeline and set.
  void bind(vk::CommandBuffer commands, const DescriptorSet& set) const noexcept;
  template <class T>
  void push(vk::CommandBuffer commands, const T& constants) const noexcept {
    static_assert(sizeof(T) <= 128);
    commands.pushConstants(*compiled_->layout, vk::ShaderStageFlagBits::eCompute, 0, sizeof(T), &constants,
                           context_->dispatch);
  }
  void dispatch(vk::CommandBuffer commands, std::uint32_t x, std::uint32_t y = 1, std::uint32_t z = 1) const noexcept {
    commands.dispatch(x, y, z, context_->dispatch);
  }
  void dispatchIndirect(vk::CommandBuffer commands, vk::Buffer arguments, vk::DeviceSize offset) const noexcept {
    commands.dispatchIndirect(arguments, offset, context_->dispatch);
  }

 private:
  Context* context_ = nullptr;
  std::shared_ptr<const CompiledPass> compiled_;
};

/// A shader module with a name.
Result<Unique<vk::ShaderModule>> createShader(Context& context, std::string_view name,
                                              std::span<const std::uint32_t> code);

/// ceil(a / b)
constexpr std::uint32_t groups(std::uint32_t a, std::uint32_t b) noexcept { return (a + b - 1) / b; }

}  // namespace pelagic::gpu
