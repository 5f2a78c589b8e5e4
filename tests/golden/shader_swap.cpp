#include "shader_swap.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace golden {

namespace {

/// Vulkan's entry points take no user data.
struct Active {
  PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr;
  PFN_vkGetDeviceProcAddr getDeviceProcAddr = nullptr;
  PFN_vkCreateShaderModule createShaderModule = nullptr;
  std::vector<Swap> swaps;
  std::vector<bool> done;
};
Active active;

template <class Function>
PFN_vkVoidFunction asVoid(Function function) {
  return reinterpret_cast<PFN_vkVoidFunction>(function);
}

VKAPI_ATTR VkResult VKAPI_CALL createShaderModule(VkDevice device, const VkShaderModuleCreateInfo* info,
                                                  const VkAllocationCallbacks* allocator, VkShaderModule* result) {
  VkShaderModuleCreateInfo changed = *info;
  const Words words(info->pCode, info->codeSize / sizeof(std::uint32_t));
  for (std::size_t i = 0; i < active.swaps.size(); ++i) {
    const auto& [original, replacement] = active.swaps[i];
    if (!std::equal(words.begin(), words.end(), original.begin(), original.end())) continue;
    changed.pCode = replacement.data();
    changed.codeSize = replacement.size_bytes();
    active.done[i] = true;
  }
  return active.createShaderModule(device, &changed, allocator, result);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDeviceProcAddr(VkDevice device, const char* name) {
  const PFN_vkVoidFunction real = active.getDeviceProcAddr(device, name);
  if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) return asVoid(getDeviceProcAddr);
  if (std::strcmp(name, "vkCreateShaderModule") != 0) return real;
  active.createShaderModule = reinterpret_cast<PFN_vkCreateShaderModule>(real);
  return asVoid(createShaderModule);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getInstanceProcAddr(VkInstance instance, const char* name) {
  const PFN_vkVoidFunction real = active.getInstanceProcAddr(instance, name);
  if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) {
    active.getDeviceProcAddr = reinterpret_cast<PFN_vkGetDeviceProcAddr>(real);
    return asVoid(getDeviceProcAddr);
  }
  if (std::strcmp(name, "vkCreateShaderModule") == 0) {
    active.createShaderModule = reinterpret_cast<PFN_vkCreateShaderModule>(real);
    return asVoid(createShaderModule);
  }
  return real;
}

}  // namespace

ShaderSwap::ShaderSwap(const pelagic::DeviceInfo& handles, std::vector<Swap> swaps) : handles_(handles) {
  if (active.getInstanceProcAddr) throw std::logic_error("two shader swaps at a time");
  active.getInstanceProcAddr = handles.getInstanceProcAddr;
  active.done.assign(swaps.size(), false);
  active.swaps = std::move(swaps);
  handles_.getInstanceProcAddr = getInstanceProcAddr;
}

ShaderSwap::~ShaderSwap() { active = {}; }

bool ShaderSwap::complete() const {
  return std::find(active.done.begin(), active.done.end(), false) == active.done.end();
}

}  // namespace golden
