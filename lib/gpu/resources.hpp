/// Buffers, images and samplers with their memory. Every image and buffer knows the state it was last left in, which
/// is right because a host submits recorded command buffers once and in recording order.
#pragma once

#include <gpu/context.hpp>
#include <pelagic/image.hpp>
#include <vector>

namespace pelagic::gpu {

/// Device memory of one resource, counted in Context::memory while it lives.
class Memory {
 public:
  Memory() noexcept = default;
  Memory(Context& context, Stage stage, vk::DeviceSize size, Unique<vk::DeviceMemory> memory) noexcept;
  Memory(Memory&& other) noexcept;
  Memory& operator=(Memory&& other) noexcept;
  ~Memory();
  vk::DeviceMemory handle() const noexcept { return *memory_; }

 private:
  Context* context_ = nullptr;
  Stage stage_{};
  vk::DeviceSize size_ = 0;
  Unique<vk::DeviceMemory> memory_;
};

struct BufferState {
  vk::PipelineStageFlags2 stages{};
  vk::AccessFlags2 access{};
};

class Buffer {
 public:
  /// upload and readback: host-visible, coherent and mapped; readback: cached as well where there is such memory.
  enum class Placement { device, upload, readback };
  static Result<Buffer> create(Context& context, Stage stage, std::string_view name, vk::DeviceSize size,
                               vk::BufferUsageFlags usage, Placement placement = Placement::device);
  vk::Buffer handle() const noexcept { return *buffer_; }
  vk::DeviceSize size() const noexcept { return size_; }
  /// Null for Placement::device.
  void* mapped() const noexcept { return mapped_; }
  BufferState state;

 private:
  Memory memory_;
  Unique<vk::Buffer> buffer_;
  vk::DeviceSize size_ = 0;
  void* mapped_ = nullptr;
};

struct ImageInfo {
  vk::Format format{};
  vk::Extent2D extent{};
  std::uint32_t depth = 1;  ///< More than 1: a 3-D image.
  std::uint32_t layers = 1;
  std::uint32_t mips = 1;
  bool array = false;  ///< The view is a 2-D array even with one layer.
  vk::ImageUsageFlags usage{};
};

class Image {
 public:
  static Result<Image> create(Context& context, Stage stage, std::string_view name, const ImageInfo& info);
  vk::Image handle() const noexcept { return *image_; }
  const ImageInfo& info() const noexcept { return info_; }
  /// All mips and layers.
  vk::ImageView view() const noexcept { return *view_; }
  /// One mip, all layers, as a storage image needs it.
  vk::ImageView mipView(std::uint32_t mip) const noexcept { return *mipViews_[mip]; }
  vk::ImageSubresourceRange range() const noexcept;
  MapView map() const noexcept;
  /// Of all mips and layers.
  ImageState state;

 private:
  Memory memory_;
  Unique<vk::Image> image_;
  Unique<vk::ImageView> view_;
  std::vector<Unique<vk::ImageView>> mipViews_;
  ImageInfo info_;
};

/// Full mip chain length of a square or oblong image.
std::uint32_t mipCount(vk::Extent2D extent) noexcept;

struct SamplerInfo {
  vk::Filter filter = vk::Filter::eLinear;
  vk::SamplerMipmapMode mipmap = vk::SamplerMipmapMode::eLinear;
  vk::SamplerAddressMode u = vk::SamplerAddressMode::eRepeat;
  vk::SamplerAddressMode v = vk::SamplerAddressMode::eRepeat;
  vk::SamplerAddressMode w = vk::SamplerAddressMode::eClampToEdge;
};
Result<Unique<vk::Sampler>> createSampler(Context& context, std::string_view name, const SamplerInfo& info);

/// All of a buffer as texels: software devices read vectors of it sooner than from a storage buffer.
Result<Unique<vk::BufferView>> createTexelView(Context& context, std::string_view name, const Buffer& buffer,
                                               vk::Format format);

}  // namespace pelagic::gpu
