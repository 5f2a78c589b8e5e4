/// Wrong shaders in the right library: the host passes vkGetInstanceProcAddr, so it can answer with a
/// vkCreateShaderModule of its own.
#pragma once

#include <pelagic/device.hpp>
#include <span>
#include <vector>

namespace golden {

using Words = std::span<const std::uint32_t>;

struct Swap {
  Words original;
  Words replacement;
};

/// While it lives, Pelagic gets each `replacement` wherever it asks for a module of exactly the words `original`.
/// One at a time.
class ShaderSwap {
 public:
  ShaderSwap(const pelagic::DeviceInfo& handles, std::vector<Swap> swaps);
  ShaderSwap(const ShaderSwap&) = delete;
  ShaderSwap& operator=(const ShaderSwap&) = delete;
  ~ShaderSwap();

  /// For pelagic::Device::create.
  const pelagic::DeviceInfo& handles() const { return handles_; }
  /// Whether every swap has taken place.
  bool complete() const;

 private:
  pelagic::DeviceInfo handles_;
};

}  // namespace golden
