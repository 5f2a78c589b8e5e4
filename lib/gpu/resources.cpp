#include <algorithm>
#include <bit>
#include <gpu/resources.hpp>
#include <string>
#include <utility>

namespace pelagic::gpu {
namespace {

Result<Memory> allocate(Context& context, Stage stage, std::string_view name, const vk::MemoryRequirements& needs,
                        vk::MemoryPropertyFlags required, const void* next, vk::MemoryPropertyFlags preferred = {}) {
  const auto& properties = context.memoryProperties;
  const auto find = [&](vk::MemoryPropertyFlags flags) {
    std::uint32_t type = 0;
    while (type < properties.memoryTypeCount && ((needs.memoryTypeBits >> type & 1u) == 0 ||
                                                 (properties.memoryTypes[type].propertyFlags & flags) != flags)) {
      ++type;
    }
    return type;
  };
  std::uint32_t type = find(required | preferred);
  if (type == properties.memoryTypeCount) type = find(required);
  if (type < properties.memoryTypeCount) {
    auto memory = context.device.allocateMemoryUnique(vk::MemoryAllocateInfo(needs.size, type, next),
                                                      context.allocator(), context.dispatch);
    if (memory.result != vk::Result::eSuccess) {
      return fail(memory.result, "allocate " + std::to_string(needs.size) + " bytes for " + std::string(name));
    }
    context.name(*memory.value, name);
    return Memory(context, stage, needs.size, std::move(memory.value));
  }
  return reject("the device has no " + vk::to_string(required) + " memory type for " + std::string(name),
                ErrorCode::unsupported);
}

}  // namespace

Memory::Memory(Context& context, Stage stage, vk::DeviceSize size, Unique<vk::DeviceMemory> memory) noexcept
    : context_(&context), stage_(stage), size_(size), memory_(std::move(memory)) {
  context_->memory[static_cast<std::size_t>(stage_)] += size_;
}

Memory::Memory(Memory&& other) noexcept
    : context_(std::exchange(other.context_, nullptr)),
      stage_(other.stage_),
      size_(other.size_),
      memory_(std::move(other.memory_)) {}

Memory& Memory::operator=(Memory&& other) noexcept {
  std::swap(context_, other.context_);
  std::swap(stage_, other.stage_);
  std::swap(size_, other.size_);
  memory_.swap(other.memory_);
  return *this;
}

Memory::~Memory() {
  if (context_) context_->memory[static_cast<std::size_t>(stage_)] -= size_;
}

Result<Buffer> Buffer::create(Context& context, Stage stage, std::string_view name, vk::DeviceSize size,
                              vk::BufferUsageFlags usage, Placement placement) {
  Buffer result;
  auto buffer =
      context.device.createBufferUnique(vk::BufferCreateInfo({}, size, usage), context.allocator(), context.dispatch);
  if (buffer.result != vk::Result::eSuccess) return fail(buffer.result, "create the buffer " + std::string(name));
  result.buffer_ = std::move(buffer.value);
  context.name(*result.buffer_, name);
  const bool mappable = placement != Placement::device;
  const vk::MemoryPropertyFlags required =
      mappable ? vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent
               : vk::MemoryPropertyFlags(vk::MemoryPropertyFlagBits::eDeviceLocal);
  const auto preferred =
      placement == Placement::readback ? vk::MemoryPropertyFlagBits::eHostCached : vk::MemoryPropertyFlagBits{};
  const auto needs = context.device.getBufferMemoryRequirements(*result.buffer_, context.dispatch);
  PELAGIC_TRY(memory, allocate(context, stage, name, needs, required, nullptr, preferred));
  result.memory_ = std::move(memory);
  result.size_ = size;
  const auto bound = context.device.bindBufferMemory(*result.buffer_, result.memory_.handle(), 0, context.dispatch);
  if (bound != vk::Result::eSuccess) return fail(bound, "bind memory to the buffer " + std::string(name));
  if (mappable) {
    auto mapped = context.device.mapMemory(result.memory_.handle(), 0, VK_WHOLE_SIZE, {}, context.dispatch);
    if (mapped.result != vk::Result::eSuccess) return fail(mapped.result, "map the buffer " + std::string(name));
    result.mapped_ = mapped.value;
  }
  return result;
}

Result<Image> Image::create(Context& context, Stage stage, std::string_view name, const ImageInfo& info) {
  Image result;
  result.info_ = info;
  const auto dimension = info.depth > 1 ? vk::ImageType::e3D : vk::ImageType::e2D;
  const vk::ImageCreateInfo create({}, dimension, info.format, {info.extent.width, info.extent.height, info.depth},
                                   info.mips, info.layers, vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal,
                                   info.usage);
  auto image = context.device.createImageUnique(create, context.allocator(), context.dispatch);
  if (image.result != vk::Result::eSuccess) return fail(image.result, "create the image " + std::string(name));
  result.image_ = std::move(image.value);
  context.name(*result.image_, name);
  // A dedicated allocation each: few, large images that live as long as their stage.
  const vk::MemoryDedicatedAllocateInfo dedicated(*result.image_);
  const auto needs = context.device.getImageMemoryRequirements(*result.image_, context.dispatch);
  PELAGIC_TRY(memory, allocate(context, stage, name, needs, vk::MemoryPropertyFlagBits::eDeviceLocal, &dedicated));
  result.memory_ = std::move(memory);
  const auto bound = context.device.bindImageMemory(*result.image_, result.memory_.handle(), 0, context.dispatch);
  if (bound != vk::Result::eSuccess) return fail(bound, "bind memory to the image " + std::string(name));

  const bool array = info.array || info.layers > 1;
  const auto type = info.depth > 1 ? vk::ImageViewType::e3D
                    : array        ? vk::ImageViewType::e2DArray
                                   : vk::ImageViewType::e2D;
  const auto makeView = [&](std::uint32_t firstMip, std::uint32_t mips) {
    auto range = result.range();
    range.baseMipLevel = firstMip;
    range.levelCount = mips;
    return context.device.createImageViewUnique(
        vk::ImageViewCreateInfo({}, *result.image_, type, info.format, {}, range), context.allocator(),
        context.dispatch);
  };
  auto view = makeView(0, info.mips);
  if (view.result != vk::Result::eSuccess) return fail(view.result, "create a view of " + std::string(name));
  result.view_ = std::move(view.value);
  context.name(*result.view_, name);
  for (std::uint32_t mip = 0; mip < info.mips; ++mip) {
    auto one = makeView(mip, 1);
    if (one.result != vk::Result::eSuccess) return fail(one.result, "create a mip view of " + std::string(name));
    context.name(*one.value, std::string(name) + " mip " + std::to_string(mip));
    result.mipViews_.push_back(std::move(one.value));
  }
  return result;
}

vk::ImageSubresourceRange Image::range() const noexcept {
  const bool depth = info_.format == vk::Format::eD32Sfloat;
  return {depth ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor, 0, info_.mips, 0, info_.layers};
}

MapView Image::map() const noexcept {
  return {*image_, *view_, static_cast<VkFormat>(info_.format), info_.extent, info_.layers, info_.mips};
}

std::uint32_t mipCount(vk::Extent2D extent) noexcept {
  return static_cast<std::uint32_t>(std::bit_width(std::max(extent.width, extent.height)));
}

Result<Unique<vk::Sampler>> createSampler(Context& context, std::string_view name, const SamplerInfo& info) {
  vk::SamplerCreateInfo create({}, info.filter, info.filter, info.mipmap, info.u, info.v, info.w);
  create.maxLod = VK_LOD_CLAMP_NONE;
  auto sampler = context.device.createSamplerUnique(create, context.allocator(), context.dispatch);
  if (sampler.result != vk::Result::eSuccess) return fail(sampler.result, "create the sampler " + std::string(name));
  context.name(*sampler.value, name);
  return std::move(sampler.value);
}

Result<Unique<vk::BufferView>> createTexelView(Context& context, std::string_view name, const Buffer& buffer,
                                               vk::Format format) {
  auto view = context.device.createBufferViewUnique(
      vk::BufferViewCreateInfo({}, buffer.handle(), format, 0, VK_WHOLE_SIZE), context.allocator(), context.dispatch);
  if (view.result != vk::Result::eSuccess) return fail(view.result, "create the view " + std::string(name));
  context.name(*view.value, name);
  return std::move(view.value);
}

}  // namespace pelagic::gpu
