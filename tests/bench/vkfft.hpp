/// VkFFT behind a plain interface.
#pragma once

#include <common/gpu_device.hpp>

namespace bench {

/// Inverse 2-D complex transforms in place, N x N each, all in one buffer.
class VkFft {
 public:
  static tl::expected<VkFft, std::string> create(const common::GpuDevice& gpu, std::uint32_t transforms,
                                                 std::uint32_t size);
  VkFft(VkFft&&) noexcept;
  VkFft& operator=(VkFft&&) noexcept;
  ~VkFft();

  void record(vk::CommandBuffer commands);
  /// Of 2 floats a sample, transform after transform.
  vk::Buffer buffer() const;
  vk::DeviceSize bytes() const;

 private:
  struct Impl;
  explicit VkFft(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace bench
