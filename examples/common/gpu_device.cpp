#include "gpu_device.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <glm/gtc/packing.hpp>

namespace common {
namespace {

/// Best-practices messages that say nothing about Pelagic's use of Vulkan.
struct AllowedMessage {
  std::string_view id;
  std::string_view reason;
};
constexpr AllowedMessage kAllowed[] = {
    {"UNASSIGNED-BestPractices-vkCreateInstance-specialuse-extension-debugging",
     "VK_EXT_debug_utils is how messages arrive here at all"},
    {"UNASSIGNED-BestPractices-vkCreateDevice-physical-device-features-not-retrieved",
     "the features are queried with vkGetPhysicalDeviceFeatures2, which this layer does not count"},
    {"UNASSIGNED-BestPractices-vkBindMemory-small-dedicated-allocation",
     "few, long-lived resources: an allocator would cost more code than the memory it saves"},
    {"UNASSIGNED-BestPractices-vkAllocateMemory-small-allocation", "as above"},
    {"UNASSIGNED-BestPractices-ImageBarrierAccessLayout",
     "this layer compares only the access flags that exist without synchronization2, so it misses SHADER_SAMPLED_READ"},
    {"UNASSIGNED-BestPractices-SpirvDeprecated_WorkgroupSize",
     "true of SPIR-V 1.6; the shaders are 1.5, which knows no other work-group size that is a specialisation constant"},
};

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  const std::string_view id = data->pMessageIdName ? data->pMessageIdName : "";
  const bool allowed =
      std::any_of(std::begin(kAllowed), std::end(kAllowed), [&](const AllowedMessage& a) { return a.id == id; });
  // The loader's own remarks about drivers that are not installed concern no one here.
  const bool loader = id == "Loader Message";
  if (!allowed && !loader) {
    static_cast<ValidationLog*>(user)->messages.push_back(std::string(id) + ": " + data->pMessage);
  }
  return VK_FALSE;
}

bool selected(const std::string& select, std::size_t index, const std::string& name) {
  const bool number =
      !select.empty() && std::all_of(select.begin(), select.end(), [](char c) { return c >= '0' && c <= '9'; });
  return number ? select == std::to_string(index) : name.find(select) != std::string::npos;
}

int preference(vk::PhysicalDeviceType type) {
  switch (type) {
    case vk::PhysicalDeviceType::eDiscreteGpu:
      return 3;
    case vk::PhysicalDeviceType::eIntegratedGpu:
      return 2;
    case vk::PhysicalDeviceType::eVirtualGpu:
      return 1;
    default:
      return 0;
  }
}

std::uint32_t memoryType(const GpuDevice& gpu, std::uint32_t bits, vk::MemoryPropertyFlags flags) {
  const auto properties = gpu.physicalDevice().getMemoryProperties();
  for (std::uint32_t i = 0; i < properties.memoryTypeCount; ++i) {
    if ((bits >> i & 1u) && (properties.memoryTypes[i].propertyFlags & flags) == flags) return i;
  }
  throw std::runtime_error("the device has no memory of type " + vk::to_string(flags));
}

struct Staging {
  vk::UniqueDeviceMemory memory;
  vk::UniqueBuffer buffer;
};

Staging createStaging(const GpuDevice& gpu, vk::DeviceSize size) {
  Staging staging;
  staging.buffer = gpu.device().createBufferUnique({{}, size, vk::BufferUsageFlagBits::eTransferDst});
  const auto needs = gpu.device().getBufferMemoryRequirements(*staging.buffer);
  const auto flags = vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;
  staging.memory = gpu.device().allocateMemoryUnique({needs.size, memoryType(gpu, needs.memoryTypeBits, flags)});
  gpu.device().bindBufferMemory(*staging.buffer, *staging.memory, 0);
  return staging;
}

std::vector<std::byte> contents(const GpuDevice& gpu, const Staging& staging, vk::DeviceSize size) {
  std::vector<std::byte> bytes(size);
  const void* mapped = gpu.device().mapMemory(*staging.memory, 0, VK_WHOLE_SIZE);
  std::memcpy(bytes.data(), mapped, size);
  gpu.device().unmapMemory(*staging.memory);
  return bytes;
}

void hostBarrier(vk::CommandBuffer commands) {
  const vk::MemoryBarrier2 barrier(vk::PipelineStageFlagBits2::eAllTransfer, vk::AccessFlagBits2::eTransferWrite,
                                   vk::PipelineStageFlagBits2::eHost, vk::AccessFlagBits2::eHostRead);
  commands.pipelineBarrier2({{}, barrier});
}

struct FormatLayout {
  vk::DeviceSize bytes;  ///< Per texel.
  int floatBits;         ///< 32, 16 or 8 (unsigned integer or unorm).
};

FormatLayout layoutOf(vk::Format format) {
  switch (format) {
    case vk::Format::eR16Sfloat:
      return {2, 16};
    case vk::Format::eR16G16Sfloat:
      return {4, 16};
    case vk::Format::eR16G16B16A16Sfloat:
      return {8, 16};
    case vk::Format::eD32Sfloat:
    case vk::Format::eR32Sfloat:
      return {4, 32};
    case vk::Format::eR32G32Sfloat:
      return {8, 32};
    case vk::Format::eR32G32B32A32Sfloat:
      return {16, 32};
    case vk::Format::eR8Uint:
    case vk::Format::eR8Unorm:
      return {1, 8};
    case vk::Format::eR8G8B8A8Unorm:
      return {4, 8};
    default:
      throw std::runtime_error("cannot read images of the format " + vk::to_string(format));
  }
}

}  // namespace

tl::expected<GpuDevice, GpuDeviceError> GpuDevice::create(const GpuDeviceOptions& options) try {
  GpuDevice gpu;
  std::vector<const char*> extensions = options.instanceExtensions;
  std::vector<const char*> layers;
  const vk::ValidationFeatureEnableEXT enables[] = {vk::ValidationFeatureEnableEXT::eBestPractices,
                                                    vk::ValidationFeatureEnableEXT::eSynchronizationValidation};
  vk::ValidationFeaturesEXT features(enables);
  using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
  using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
  vk::DebugUtilsMessengerCreateInfoEXT messenger({}, Severity::eWarning | Severity::eError,
                                                 Type::eGeneral | Type::eValidation | Type::ePerformance, onMessage,
                                                 gpu.log_.get());
  const vk::ApplicationInfo application("pelagic", 0, "pelagic", 0, VK_API_VERSION_1_3);
  vk::InstanceCreateInfo create({}, &application);
  if (options.validate) {
    layers.push_back("VK_LAYER_KHRONOS_validation");
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    features.pNext = &messenger;
    create.pNext = &features;
  }
  create.setPEnabledLayerNames(layers);
  create.setPEnabledExtensionNames(extensions);
  gpu.instance_ = vk::createInstanceUnique(create);
  gpu.dispatch_ = std::make_unique<vk::DispatchLoaderDynamic>(*gpu.instance_, vkGetInstanceProcAddr);
  if (options.validate) {
    gpu.messenger_ = gpu.instance_->createDebugUtilsMessengerEXTUnique(messenger, nullptr, *gpu.dispatch_);
  }

  const auto devices = gpu.instance_->enumeratePhysicalDevices();
  std::string names;
  int best = -1;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const auto properties = devices[i].getProperties();
    const std::string name = properties.deviceName;
    names += (i ? ", " : "") + std::to_string(i) + " '" + name + "'";
    if (preference(properties.deviceType) > best && selected(options.select, i, name)) {
      best = preference(properties.deviceType);
      gpu.physicalDevice_ = devices[i];
    }
  }
  if (!gpu.physicalDevice_) {
    if (devices.empty()) return tl::unexpected(GpuDeviceError{false, "there is no Vulkan device"});
    return tl::unexpected(GpuDeviceError{true, "--device is '" + options.select + "', allowed: " + names});
  }

  const auto families = gpu.physicalDevice_.getQueueFamilyProperties();
  const vk::QueueFlags needed = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
  while (gpu.queueFamily_ < families.size() && (families[gpu.queueFamily_].queueFlags & needed) != needed) {
    ++gpu.queueFamily_;
  }
  if (gpu.queueFamily_ == families.size()) {
    return tl::unexpected(GpuDeviceError{false, gpu.name() + " has no graphics and compute queue"});
  }
  const float priority = 1;
  const vk::DeviceQueueCreateInfo queue({}, gpu.queueFamily_, 1, &priority);
  const pelagic::RequiredFeatures required;
  vk::DeviceCreateInfo deviceInfo({}, queue);
  deviceInfo.setPEnabledExtensionNames(options.deviceExtensions);
  deviceInfo.pNext = &required.features;
  gpu.device_ = gpu.physicalDevice_.createDeviceUnique(deviceInfo);
  gpu.queue_ = gpu.device_->getQueue(gpu.queueFamily_, 0);
  gpu.pool_ = gpu.device_->createCommandPoolUnique({vk::CommandPoolCreateFlagBits::eTransient, gpu.queueFamily_});
  return gpu;
} catch (const std::exception& error) {
  return tl::unexpected(GpuDeviceError{false, std::string("cannot create a Vulkan device: ") + error.what()});
}

std::string GpuDevice::name() const { return physicalDevice_.getProperties().deviceName; }

pelagic::DeviceInfo GpuDevice::info() const {
  pelagic::DeviceInfo info;
  info.instance = *instance_;
  info.physicalDevice = physicalDevice_;
  info.device = *device_;
  info.queueFamily = queueFamily_;
  info.getInstanceProcAddr = vkGetInstanceProcAddr;
  info.debugUtils = static_cast<bool>(messenger_);
  return info;
}

void GpuDevice::run(const std::function<void(vk::CommandBuffer)>& record) const {
  const auto buffers = device_->allocateCommandBuffersUnique({*pool_, vk::CommandBufferLevel::ePrimary, 1});
  const vk::CommandBuffer commands = *buffers.front();
  commands.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
  record(commands);
  commands.end();
  const auto fence = device_->createFenceUnique({});
  queue_.submit(vk::SubmitInfo({}, {}, commands), *fence);
  constexpr std::uint64_t kTimeout = 600'000'000'000;  // 10 min in ns: a software device may be slow, never that slow
  if (device_->waitForFences(*fence, VK_TRUE, kTimeout) != vk::Result::eSuccess) {
    throw std::runtime_error("the device did not finish within ten minutes");
  }
}

OwnedImage& OwnedImage::operator=(OwnedImage&& other) noexcept {
  view = std::move(other.view);
  image = std::move(other.image);
  memory = std::move(other.memory);
  format = other.format;
  extent = other.extent;
  return *this;
}

pelagic::HostImage OwnedImage::host(const pelagic::ImageState& before, const pelagic::ImageState& after) const {
  return {*image, *view, static_cast<VkFormat>(format), extent, before, after};
}

void GpuDevice::setName(vk::Image image, const std::string& name) const {
  if (!messenger_) return;  // VK_EXT_debug_utils is enabled with validation only
  const auto handle = reinterpret_cast<std::uint64_t>(static_cast<VkImage>(image));
  device_->setDebugUtilsObjectNameEXT({vk::ObjectType::eImage, handle, name.c_str()}, *dispatch_);
}

OwnedImage createImage(const GpuDevice& gpu, vk::Format format, vk::Extent2D extent, vk::ImageUsageFlags usage,
                       const std::string& name) {
  OwnedImage result;
  result.format = format;
  result.extent = extent;
  result.image = gpu.device().createImageUnique({{},
                                                 vk::ImageType::e2D,
                                                 format,
                                                 {extent.width, extent.height, 1},
                                                 1,
                                                 1,
                                                 vk::SampleCountFlagBits::e1,
                                                 vk::ImageTiling::eOptimal,
                                                 usage});
  gpu.setName(*result.image, name);
  const auto needs = gpu.device().getImageMemoryRequirements(*result.image);
  const std::uint32_t type = memoryType(gpu, needs.memoryTypeBits, vk::MemoryPropertyFlagBits::eDeviceLocal);
  const auto properties = gpu.physicalDevice().getMemoryProperties();
  const vk::DeviceSize heap = properties.memoryHeaps[properties.memoryTypes[type].heapIndex].size;
  if (needs.size > heap) {  // a software device would promise the memory and be killed for using it
    throw std::runtime_error("an image of " + std::to_string(needs.size) + " bytes does not fit into the device's " +
                             std::to_string(heap));
  }
  result.memory = gpu.device().allocateMemoryUnique({needs.size, type});
  gpu.device().bindImageMemory(*result.image, *result.memory, 0);
  const auto aspect =
      format == vk::Format::eD32Sfloat ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
  result.view =
      gpu.device().createImageViewUnique({{}, *result.image, vk::ImageViewType::e2D, format, {}, {aspect, 0, 1, 0, 1}});
  return result;
}

std::vector<std::byte> readImage(const GpuDevice& gpu, vk::Image image, vk::Format format, vk::Extent2D extent,
                                 const pelagic::ImageState& state, std::uint32_t mip, std::uint32_t layer) {
  const std::uint32_t width = std::max(1u, extent.width >> mip);
  const std::uint32_t height = std::max(1u, extent.height >> mip);
  const vk::DeviceSize size = layoutOf(format).bytes * width * height;
  const Staging staging = createStaging(gpu, size);
  const auto aspect =
      format == vk::Format::eD32Sfloat ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
  const auto barrier = [&](const pelagic::ImageState& from, const pelagic::ImageState& to) {
    return vk::ImageMemoryBarrier2(vk::PipelineStageFlags2(from.stages), vk::AccessFlags2(from.access),
                                   vk::PipelineStageFlags2(to.stages), vk::AccessFlags2(to.access),
                                   vk::ImageLayout(from.layout), vk::ImageLayout(to.layout), VK_QUEUE_FAMILY_IGNORED,
                                   VK_QUEUE_FAMILY_IGNORED, image, {aspect, mip, 1, layer, 1});
  };
  gpu.run([&](vk::CommandBuffer commands) {
    const auto in = barrier(state, kTransferSource);
    commands.pipelineBarrier2({{}, {}, {}, in});
    const vk::BufferImageCopy copy(0, 0, 0, {aspect, mip, layer, 1}, {}, {width, height, 1});
    commands.copyImageToBuffer(image, vk::ImageLayout::eTransferSrcOptimal, *staging.buffer, copy);
    const auto out = barrier(kTransferSource, state);
    commands.pipelineBarrier2({{}, {}, {}, out});
    hostBarrier(commands);
  });
  return contents(gpu, staging, size);
}

std::vector<float> readFloats(const GpuDevice& gpu, vk::Image image, vk::Format format, vk::Extent2D extent,
                              const pelagic::ImageState& state, std::uint32_t mip, std::uint32_t layer) {
  const auto bytes = readImage(gpu, image, format, extent, state, mip, layer);
  const int bits = layoutOf(format).floatBits;
  std::vector<float> values(bytes.size() * 8 / static_cast<std::size_t>(bits));
  if (bits == 32) std::memcpy(values.data(), bytes.data(), bytes.size());
  for (std::size_t i = 0; i < values.size() && bits != 32; ++i) {
    if (bits == 16) {
      std::uint16_t half = 0;
      std::memcpy(&half, bytes.data() + 2 * i, 2);
      values[i] = glm::unpackHalf1x16(half);
    } else {
      values[i] = static_cast<float>(bytes[i]);
    }
  }
  return values;
}

std::vector<float> readFloats(const GpuDevice& gpu, const pelagic::MapView& map, std::uint32_t mip,
                              std::uint32_t layer) {
  return readFloats(gpu, map.image, vk::Format(map.format), map.extent, pelagic::kShaderRead, mip, layer);
}

std::vector<std::byte> readBuffer(const GpuDevice& gpu, vk::Buffer buffer, vk::DeviceSize size) {
  const Staging staging = createStaging(gpu, size);
  gpu.run([&](vk::CommandBuffer commands) {
    const vk::MemoryBarrier2 before(vk::PipelineStageFlagBits2::eAllTransfer |
                                        vk::PipelineStageFlagBits2::eComputeShader |
                                        vk::PipelineStageFlagBits2::eFragmentShader,
                                    vk::AccessFlagBits2::eMemoryWrite, vk::PipelineStageFlagBits2::eAllTransfer,
                                    vk::AccessFlagBits2::eTransferRead);
    commands.pipelineBarrier2({{}, before});
    commands.copyBuffer(buffer, *staging.buffer, vk::BufferCopy(0, 0, size));
    hostBarrier(commands);
  });
  return contents(gpu, staging, size);
}

}  // namespace common
