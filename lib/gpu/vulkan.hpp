/// The one place that configures vulkan.hpp: no exceptions, no linked symbols, an explicit dispatcher on every call.
#pragma once

#define VK_NO_PROTOTYPES
// A host may use vulkan.hpp too, with other settings or another NDEBUG, on which the layout of its classes depends: in
// a namespace of its own Pelagic's copy cannot be mistaken for the host's when both are linked.
#define VULKAN_HPP_NAMESPACE pelagic_vk
#define VULKAN_HPP_NO_EXCEPTIONS
// Failures travel in vk::ResultValue; the default assertion would abort a host's debug build instead.
#define VULKAN_HPP_ASSERT_ON_RESULT(x) static_cast<void>(0)
#define VULKAN_HPP_DISPATCH_LOADER_DYNAMIC 1
#define VULKAN_HPP_ENABLE_DYNAMIC_LOADER_TOOL 0
#define VULKAN_HPP_NO_DEFAULT_DISPATCHER
#define VULKAN_HPP_NO_SPACESHIP_OPERATOR
#include <vulkan/vulkan.hpp>

namespace vk = VULKAN_HPP_NAMESPACE;
