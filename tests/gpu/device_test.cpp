#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <pelagic/sky.hpp>
#include <pelagic/timings.hpp>
#include <string_view>

#include "support/gpu_test.hpp"

namespace {

class DeviceTest : public support::GpuTest {};

/// The loader as it would be on a device that lacks synchronization2 and has 64 bytes of push constants.
PFN_vkVoidFunction VKAPI_CALL lesserDevice(VkInstance instance, const char* name) {
  const std::string_view wanted = name;
  if (wanted == "vkGetPhysicalDeviceFeatures2") {
    return reinterpret_cast<PFN_vkVoidFunction>(
        +[](VkPhysicalDevice device, VkPhysicalDeviceFeatures2* features) VKAPI_CALL {
          vkGetPhysicalDeviceFeatures2(device, features);
          for (auto* next = static_cast<VkBaseOutStructure*>(features->pNext); next; next = next->pNext) {
            if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES) {
              reinterpret_cast<VkPhysicalDeviceVulkan13Features*>(next)->synchronization2 = VK_FALSE;
            }
          }
        });
  }
  return vkGetInstanceProcAddr(instance, name);
}

PFN_vkVoidFunction VKAPI_CALL smallerDevice(VkInstance instance, const char* name) {
  const std::string_view wanted = name;
  if (wanted == "vkGetPhysicalDeviceProperties2") {
    return reinterpret_cast<PFN_vkVoidFunction>(+[](VkPhysicalDevice device, VkPhysicalDeviceProperties2* properties)
                                                     VKAPI_CALL {
                                                       vkGetPhysicalDeviceProperties2(device, properties);
                                                       properties->properties.limits.maxPushConstantsSize = 64;
                                                     });
  }
  return vkGetInstanceProcAddr(instance, name);
}

/// Compute pipelines that were compiled on a device of countingDevice().
std::uint32_t compiled = 0;

PFN_vkVoidFunction VKAPI_CALL countingPipelines(VkDevice device, const char* name) {
  const std::string_view wanted = name;
  if (wanted == "vkGetDeviceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(countingPipelines);
  if (wanted != "vkCreateComputePipelines") return vkGetDeviceProcAddr(device, name);
  return reinterpret_cast<PFN_vkVoidFunction>(
      +[](VkDevice owner, VkPipelineCache cache, std::uint32_t count, const VkComputePipelineCreateInfo* infos,
          const VkAllocationCallbacks* allocator, VkPipeline* pipelines) VKAPI_CALL {
        compiled += count;
        return vkCreateComputePipelines(owner, cache, count, infos, allocator, pipelines);
      });
}

PFN_vkVoidFunction VKAPI_CALL countingDevice(VkInstance instance, const char* name) {
  if (std::string_view(name) != "vkGetDeviceProcAddr") return vkGetInstanceProcAddr(instance, name);
  return reinterpret_cast<PFN_vkVoidFunction>(countingPipelines);
}

TEST_F(DeviceTest, MissingFeatureIsNamed) {
  pelagic::DeviceInfo info = gpu().info();
  info.getInstanceProcAddr = lesserDevice;
  const auto device = pelagic::Device::create(info);
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().code, pelagic::ErrorCode::unsupported);
  EXPECT_EQ(device.error().message, "the device lacks the feature synchronization2");
}

TEST_F(DeviceTest, TooSmallLimitIsNamedWithBothValues) {
  pelagic::DeviceInfo info = gpu().info();
  info.getInstanceProcAddr = smallerDevice;
  const auto device = pelagic::Device::create(info);
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().message, "the device's maxPushConstantsSize is 64, at least 128 is needed");
}

/// Counts what goes through the host's allocation callbacks.
struct CountingAllocator {
  std::map<void*, std::size_t> live;
  std::size_t calls = 0;

  static void* VKAPI_CALL allocate(void* self, std::size_t size, std::size_t alignment, VkSystemAllocationScope) {
    auto& counter = *static_cast<CountingAllocator*>(self);
    const std::size_t whole = (size + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(std::max(alignment, sizeof(void*)), std::max(whole, sizeof(void*)));
    counter.live[memory] = size;
    ++counter.calls;
    return memory;
  }
  static void* VKAPI_CALL reallocate(void* self, void* old, std::size_t size, std::size_t alignment,
                                     VkSystemAllocationScope scope) {
    void* memory = allocate(self, size, alignment, scope);
    if (old) std::memcpy(memory, old, std::min(size, static_cast<CountingAllocator*>(self)->live[old]));
    release(self, old);
    return memory;
  }
  static void VKAPI_CALL release(void* self, void* memory) {
    static_cast<CountingAllocator*>(self)->live.erase(memory);
    std::free(memory);
  }
};

TEST_F(DeviceTest, HostAllocatorIsUsedAndGivenEverythingBack) {
  CountingAllocator counter;
  VkAllocationCallbacks callbacks{};
  callbacks.pUserData = &counter;
  callbacks.pfnAllocation = CountingAllocator::allocate;
  callbacks.pfnReallocation = CountingAllocator::reallocate;
  callbacks.pfnFree = CountingAllocator::release;
  pelagic::DeviceInfo info = gpu().info();
  info.allocator = &callbacks;
  {
    auto device = pelagic::Device::create(info);
    ASSERT_TRUE(device);
    const auto timings = pelagic::Timings::create(*device);
    ASSERT_TRUE(timings);
    EXPECT_GT(counter.calls, 0u);
  }
  EXPECT_TRUE(counter.live.empty());
}

TEST_F(DeviceTest, CompilesEachPipelineOnce) {
  pelagic::DeviceInfo info = gpu().info();
  info.getInstanceProcAddr = countingDevice;
  auto counted = pelagic::Device::create(info);
  ASSERT_TRUE(counted);
  const auto compiledFor = [&](double planetRadius) {
    const std::uint32_t before = compiled;
    const auto sky = pelagic::Sky::create(*counted, {}, planetRadius);
    EXPECT_TRUE(sky && pelagic::SkyView::create(*sky, {64, 64}));
    return compiled - before;
  };
  EXPECT_GT(compiledFor(pelagic::kEarthRadius), 10u);
  EXPECT_EQ(compiledFor(pelagic::kEarthRadius), 0u) << "of a second sky, when the first has gone";
  EXPECT_GT(compiledFor(2e6), 0u) << "the radius is one of their constants";
}

TEST_F(DeviceTest, NullHandleIsNamed) {
  pelagic::DeviceInfo info = gpu().info();
  info.device = VK_NULL_HANDLE;
  const auto device = pelagic::Device::create(info);
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().message, "DeviceInfo::device is null");
}

TEST_F(DeviceTest, QueueFamilyOutOfRangeIsNamed) {
  pelagic::DeviceInfo info = gpu().info();
  info.queueFamily = 99;
  const auto device = pelagic::Device::create(info);
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().code, pelagic::ErrorCode::invalidArgument);
  EXPECT_NE(device.error().message.find("queueFamily is 99"), std::string::npos);
}

TEST_F(DeviceTest, TimingsMeasureWhatLiesBetween) {
  auto timings = pelagic::Timings::create(device());
  ASSERT_TRUE(timings);
  gpu().run([&](vk::CommandBuffer commands) {
    timings->reset(commands);
    timings->begin(commands, "nothing");
    timings->end(commands);
  });
  const auto passes = timings->read();
  ASSERT_TRUE(passes);
  ASSERT_EQ(passes->size(), 1u);
  EXPECT_STREQ((*passes)[0].name, "nothing");
  EXPECT_GE((*passes)[0].milliseconds, 0);
}

}  // namespace
