/// Descriptor set layouts and sets. Sets are written when a stage or view is created, never while recording.
#pragma once

#include <gpu/resources.hpp>
#include <span>
#include <vector>

namespace pelagic::gpu {

struct Binding {
  std::uint32_t index = 0;
  vk::DescriptorType type{};
  std::uint32_t count = 1;
};

/// One descriptor set with a pool of its own.
class DescriptorSet {
 public:
  vk::DescriptorSet handle() const noexcept { return set_; }
  void buffer(std::uint32_t binding, vk::Buffer buffer, vk::DeviceSize offset = 0,
              vk::DeviceSize range = VK_WHOLE_SIZE);
  void storageImage(std::uint32_t binding, vk::ImageView view, std::uint32_t element = 0);
  void sampled(std::uint32_t binding, vk::ImageView view, vk::Sampler sampler, std::uint32_t element = 0,
               vk::ImageLayout layout = vk::ImageLayout::eShaderReadOnlyOptimal);
  void texelBuffer(std::uint32_t binding, vk::BufferView view);

 private:
  friend class DescriptorLayout;
  vk::DescriptorType typeOf(std::uint32_t binding) const;
  Context* context_ = nullptr;
  Unique<vk::DescriptorPool> pool_;
  vk::DescriptorSet set_;
  std::vector<Binding> bindings_;
};

class DescriptorLayout {
 public:
  static Result<DescriptorLayout> create(Context& context, std::string_view name, std::span<const Binding> bindings,
                                         vk::ShaderStageFlags stages);
  Result<DescriptorSet> createSet(std::string_view name) const;
  vk::DescriptorSetLayout handle() const noexcept { return *layout_; }

 private:
  Context* context_ = nullptr;
  Unique<vk::DescriptorSetLayout> layout_;
  std::vector<Binding> bindings_;
};

}  // namespace pelagic::gpu
