/// The host's device, as Pelagic sees it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <pelagic/result.hpp>

namespace pelagic {

namespace gpu {
struct Context;
}

/// The host's handles. All of them must outlive the Device and everything created from it.
struct DeviceInfo {
  /// Created with apiVersion >= 1.3.
  VkInstance instance = VK_NULL_HANDLE;
  /// Vulkan >= 1.3.
  VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
  /// Created with at least the features of RequiredFeatures enabled.
  VkDevice device = VK_NULL_HANDLE;
  /// Index of a family with graphics and compute; the host submits Pelagic's commands to a queue of it.
  std::uint32_t queueFamily = 0;
  PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr;
  /// Optional; used for every Vulkan object that Pelagic creates.
  const VkAllocationCallbacks* allocator = nullptr;
  /// Whether the instance was created with VK_EXT_debug_utils, which Vulkan itself does not tell: every object then
  /// gets a name for debuggers and validation messages.
  bool debugUtils = false;
  /// Optional; makes later starts faster.
  VkPipelineCache pipelineCache = VK_NULL_HANDLE;
};

/// The features a host has to enable, as a chain to put into VkDeviceCreateInfo::pNext or to merge into its own.
/// Not copyable: the chain points into itself.
struct RequiredFeatures {
  RequiredFeatures() noexcept;
  RequiredFeatures(const RequiredFeatures&) = delete;
  RequiredFeatures& operator=(const RequiredFeatures&) = delete;
  VkPhysicalDeviceVulkan13Features v13{};
  /// Head of the chain.
  VkPhysicalDeviceFeatures2 features{};
};

/// The stages that own device memory.
enum class Stage : std::uint32_t { waves, sky, surface, composite, count };

/// Bytes of device memory that each stage holds now, indexed by Stage.
using MemoryUsage = std::array<std::uint64_t, static_cast<std::size_t>(Stage::count)>;

/// What every stage is created from. Must outlive them. Keeps their compute pipelines until it goes, so that whatever
/// is created later with the same ones compiles none; another planet's radius is another set. Move-only; `create`, the
/// members, and whatever creates a stage or a view from it or sets lights, are not synchronised against each other:
/// one thread at a time per Device.
class Device {
 public:
  /// Loads entry points and checks features, limits and formats.
  /// Errors: invalidArgument for a null handle or a bad queue family, unsupported with the name of what is missing.
  static Result<Device> create(const DeviceInfo& info);
  Device(Device&&) noexcept;
  Device& operator=(Device&&) noexcept;
  ~Device();

  MemoryUsage memory() const noexcept;
  /// For Pelagic's own stages.
  gpu::Context& context() const noexcept { return *context_; }

 private:
  explicit Device(std::unique_ptr<gpu::Context> context) noexcept;
  std::unique_ptr<gpu::Context> context_;
};

}  // namespace pelagic
