#include <gpu/context.hpp>
#include <sstream>

namespace pelagic {
namespace gpu {

void Context::name(vk::ObjectType type, std::uint64_t handle, std::string_view text) const {
  if (!namesObjects) return;
  const std::string copy(text);
  // A name is a help for debugging: that it cannot be set is no failure of the caller's.
  static_cast<void>(
      device.setDebugUtilsObjectNameEXT(vk::DebugUtilsObjectNameInfoEXT(type, handle, copy.c_str()), dispatch));
}

Error vulkanError(vk::Result result, std::string_view what) {
  ErrorCode code = ErrorCode::driver;
  if (result == vk::Result::eErrorOutOfHostMemory || result == vk::Result::eErrorOutOfDeviceMemory) {
    code = ErrorCode::outOfMemory;
  } else if (result == vk::Result::eErrorDeviceLost) {
    code = ErrorCode::deviceLost;
  }
  return {code, static_cast<VkResult>(result), "cannot " + std::string(what) + ": " + vk::to_string(result)};
}

Result<void> requireFormat(const Context& context, vk::Format format, vk::FormatFeatureFlags features) {
  const auto has = context.physicalDevice.getFormatProperties(format, context.dispatch).optimalTilingFeatures;
  if ((has & features) == features) return {};
  return reject("the device's format " + vk::to_string(format) + " lacks " + vk::to_string(features & ~has),
                ErrorCode::unsupported);
}

namespace {

struct Need {
  bool present;
  const char* name;
};

Result<void> checkFeatures(const Context& context) {
  const auto chain =
      context.physicalDevice.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan13Features>(
          context.dispatch);
  const auto& base = chain.get<vk::PhysicalDeviceFeatures2>().features;
  const auto& v13 = chain.get<vk::PhysicalDeviceVulkan13Features>();
  const Need needs[] = {
      {v13.dynamicRendering == VK_TRUE, "dynamicRendering"},
      {v13.synchronization2 == VK_TRUE, "synchronization2"},
      {v13.maintenance4 == VK_TRUE, "maintenance4"},
      {base.shaderStorageImageWriteWithoutFormat == VK_TRUE, "shaderStorageImageWriteWithoutFormat"},
      {base.shaderStorageImageExtendedFormats == VK_TRUE, "shaderStorageImageExtendedFormats"},
      {base.depthClamp == VK_TRUE, "depthClamp"},
  };
  for (const Need& need : needs) {
    if (!need.present) {
      return reject(std::string("the device lacks the feature ") + need.name, ErrorCode::unsupported);
    }
  }
  return {};
}

Result<void> checkLimits(const Context& context) {
  const auto& limits = context.properties.limits;
  struct Limit {
    std::uint64_t has, needs;
    const char* name;
  };
  const Limit checks[] = {
      {limits.maxComputeWorkGroupInvocations, 256, "maxComputeWorkGroupInvocations"},
      {limits.maxComputeSharedMemorySize, 32768, "maxComputeSharedMemorySize"},
      {limits.maxPushConstantsSize, 128, "maxPushConstantsSize"},
      {limits.maxPerStageDescriptorStorageImages, 24, "maxPerStageDescriptorStorageImages"},
      {limits.timestampComputeAndGraphics, 1, "timestampComputeAndGraphics"},
  };
  for (const Limit& check : checks) {
    if (check.has < check.needs) {
      return reject(std::string("the device's ") + check.name + " is " + std::to_string(check.has) + ", at least " +
                        std::to_string(check.needs) + " is needed",
                    ErrorCode::unsupported);
    }
  }
  return {};
}

Result<void> checkFormats(const Context& context) {
  using F = vk::FormatFeatureFlagBits;
  const vk::FormatFeatureFlags map = F::eStorageImage | F::eSampledImage | F::eSampledImageFilterLinear;
  const std::pair<vk::Format, vk::FormatFeatureFlags> needs[] = {
      {vk::Format::eR16G16B16A16Sfloat, map},
      {vk::Format::eR16Sfloat, map},
      {vk::Format::eR32G32Sfloat, F::eColorAttachment | F::eSampledImage},
      {vk::Format::eR16G16Sfloat, F::eColorAttachment | F::eSampledImage},
      {vk::Format::eR8Uint, F::eColorAttachment | F::eSampledImage},
      {vk::Format::eD32Sfloat, F::eDepthStencilAttachment | F::eSampledImage},
  };
  for (const auto& [format, features] : needs) PELAGIC_CHECK(requireFormat(context, format, features));
  return {};
}

}  // namespace
}  // namespace gpu

RequiredFeatures::RequiredFeatures() noexcept {
  v13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
  v13.dynamicRendering = v13.synchronization2 = v13.maintenance4 = VK_TRUE;
  features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
  features.pNext = &v13;
  features.features.shaderStorageImageWriteWithoutFormat = VK_TRUE;
  features.features.shaderStorageImageExtendedFormats = VK_TRUE;
  features.features.depthClamp = VK_TRUE;
}

Device::Device(std::unique_ptr<gpu::Context> context) noexcept : context_(std::move(context)) {}
Device::Device(Device&&) noexcept = default;
Device& Device::operator=(Device&&) noexcept = default;
Device::~Device() = default;

Result<Device> Device::create(const DeviceInfo& info) {
  const gpu::Need handles[] = {{info.instance != VK_NULL_HANDLE, "instance"},
                               {info.physicalDevice != VK_NULL_HANDLE, "physicalDevice"},
                               {info.device != VK_NULL_HANDLE, "device"},
                               {info.getInstanceProcAddr != nullptr, "getInstanceProcAddr"}};
  for (const auto& handle : handles) {
    if (!handle.present) return gpu::reject(std::string("DeviceInfo::") + handle.name + " is null");
  }
  auto context = std::make_unique<gpu::Context>();
  context->instance = info.instance;
  context->physicalDevice = info.physicalDevice;
  context->device = info.device;
  context->queueFamily = info.queueFamily;
  context->pipelineCache = info.pipelineCache;
  if (info.allocator) {
    context->allocatorStorage = *info.allocator;
    context->hasAllocator = true;
  }
  context->dispatch.init(info.instance, info.getInstanceProcAddr, info.device);
  context->namesObjects = info.debugUtils && context->dispatch.vkSetDebugUtilsObjectNameEXT != nullptr;
  vk::PhysicalDeviceProperties2 properties;
  context->physicalDevice.getProperties2(&properties, context->dispatch);
  context->properties = properties.properties;
  context->memoryProperties = context->physicalDevice.getMemoryProperties(context->dispatch);

  if (context->properties.apiVersion < VK_API_VERSION_1_3) {
    std::ostringstream text;
    text << "the device supports Vulkan " << VK_API_VERSION_MAJOR(context->properties.apiVersion) << '.'
         << VK_API_VERSION_MINOR(context->properties.apiVersion) << ", at least 1.3 is needed";
    return gpu::reject(text.str(), ErrorCode::unsupported);
  }
  const auto families = context->physicalDevice.getQueueFamilyProperties(context->dispatch);
  const vk::QueueFlags needed = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
  if (info.queueFamily >= families.size() || (families[info.queueFamily].queueFlags & needed) != needed) {
    return gpu::reject("DeviceInfo::queueFamily is " + std::to_string(info.queueFamily) +
                       ", it must be one of the device's " + std::to_string(families.size()) +
                       " families and have graphics and compute");
  }
  const std::uint32_t timestampBits = families[info.queueFamily].timestampValidBits;
  if (timestampBits == 0) return gpu::reject("the queue family has no timestamps", ErrorCode::unsupported);
  context->timestampMask = ~0ull >> (64 - timestampBits);
  PELAGIC_CHECK(gpu::checkFeatures(*context));
  PELAGIC_CHECK(gpu::checkLimits(*context));
  PELAGIC_CHECK(gpu::checkFormats(*context));
  return Device(std::move(context));
}

MemoryUsage Device::memory() const noexcept { return context_->memory; }

}  // namespace pelagic
