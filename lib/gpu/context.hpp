/// What every Pelagic object needs from the device.
#pragma once

#include <array>
#include <cstdint>
#include <gpu/vulkan.hpp>
#include <map>
#include <memory>
#include <pelagic/device.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace pelagic::gpu {

using Dispatch = vk::DispatchLoaderDynamic;
template <class T>
using Unique = vk::UniqueHandle<T, Dispatch>;

struct CompiledPass;

/// Lives on the heap and is never moved: unique handles point to `dispatch` and `allocator`.
struct Context {
  vk::Instance instance;
  vk::PhysicalDevice physicalDevice;
  vk::Device device;
  std::uint32_t queueFamily = 0;
  vk::PipelineCache pipelineCache;
  Dispatch dispatch;
  vk::AllocationCallbacks allocatorStorage;
  bool hasAllocator = false;
  vk::PhysicalDeviceProperties properties;
  vk::PhysicalDeviceMemoryProperties memoryProperties;
  std::uint64_t timestampMask = ~0ull;  ///< The bits of a timestamp that the queue family counts.
  bool namesObjects = false;
  MemoryUsage memory{};
  /// Every compute pipeline of this device, by its code and by what it was specialised with: a new view, or an ocean
  /// in place of another, compiles none of them again.
  std::map<std::pair<const std::uint32_t*, std::vector<std::uint32_t>>, std::shared_ptr<const CompiledPass>> passes;

  vk::Optional<const vk::AllocationCallbacks> allocator() const noexcept {
    return vk::Optional<const vk::AllocationCallbacks>(hasAllocator ? &allocatorStorage : nullptr);
  }
  /// Names an object for debuggers and validation messages; does nothing without VK_EXT_debug_utils.
  void name(vk::ObjectType type, std::uint64_t handle, std::string_view text) const;
  template <class T>
  void name(T handle, std::string_view text) const {
    name(T::objectType, reinterpret_cast<std::uint64_t>(static_cast<typename T::CType>(handle)), text);
  }
};

/// unsupported, with the name of the format and of what it lacks, unless images of optimal tiling have all `features`.
Result<void> requireFormat(const Context& context, vk::Format format, vk::FormatFeatureFlags features);

/// The error of a failed Vulkan call; `what` completes "cannot ...".
Error vulkanError(vk::Result result, std::string_view what);
inline tl::unexpected<Error> fail(vk::Result result, std::string_view what) {
  return tl::unexpected(vulkanError(result, what));
}
/// An invalidArgument or unsupported error with the sentence `message`.
inline tl::unexpected<Error> reject(std::string message, ErrorCode code = ErrorCode::invalidArgument) {
  return tl::unexpected(Error{code, VK_SUCCESS, std::move(message)});
}

}  // namespace pelagic::gpu

/// `PELAGIC_TRY(x, call())` declares x from a Result or returns its error; `PELAGIC_CHECK(call())` only passes errors
/// on.
#define PELAGIC_TRY_JOIN2(a, b) a##b
#define PELAGIC_TRY_JOIN(a, b) PELAGIC_TRY_JOIN2(a, b)
#define PELAGIC_TRY_IMPL(tmp, name, ...)                                     \
  auto tmp = __VA_ARGS__;                                                    \
  if (!tmp) return tl::unexpected<::pelagic::Error>(std::move(tmp.error())); \
  auto name = std::move(*tmp)
#define PELAGIC_TRY(name, ...) PELAGIC_TRY_IMPL(PELAGIC_TRY_JOIN(pelagicTry, __LINE__), name, __VA_ARGS__)
#define PELAGIC_CHECK(...)                            \
  if (auto pelagicCheck = __VA_ARGS__; !pelagicCheck) \
  return tl::unexpected<::pelagic::Error>(std::move(pelagicCheck.error()))
