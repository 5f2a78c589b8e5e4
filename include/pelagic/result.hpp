/// How Pelagic reports failure: no exception crosses the API.
#pragma once

#include <vulkan/vulkan_core.h>

#include <string>
#include <tl/expected.hpp>

namespace pelagic {

enum class ErrorCode {
  invalidArgument,  ///< A value the caller gave is outside its range; nothing was changed.
  unsupported,      ///< The device lacks a feature, limit or format that Pelagic needs.
  outOfMemory,      ///< Host or device memory ran out.
  deviceLost,       ///< The device was lost; destroy everything and start again.
  driver,           ///< Any other failing Vulkan call.
};

struct Error {
  ErrorCode code{};
  /// What Vulkan returned, VK_SUCCESS where no Vulkan call failed.
  VkResult result = VK_SUCCESS;
  /// One sentence that names the field or call, the value and the allowed range.
  std::string message;
};

template <class T>
using Result = tl::expected<T, Error>;

}  // namespace pelagic
