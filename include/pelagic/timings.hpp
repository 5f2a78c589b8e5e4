/// GPU time of every pass, from timestamps.
#pragma once

#include <pelagic/device.hpp>
#include <span>

namespace pelagic {

/// One set of timestamps for one command buffer. Move-only.
class Timings {
 public:
  struct Pass {
    const char* name;
    double milliseconds;
  };
  static constexpr std::uint32_t kMaxPasses = 64;

  static Result<Timings> create(Device& device);
  Timings(Timings&&) noexcept;
  Timings& operator=(Timings&&) noexcept;
  ~Timings();

  /// Resets the set; record before the first begin() of a command buffer, outside rendering.
  void reset(VkCommandBuffer commands) noexcept;
  /// Starts a pass. `name` must live as long as the results are used. Beyond kMaxPasses a pass is not measured.
  void begin(VkCommandBuffer commands, const char* name) noexcept;
  void end(VkCommandBuffer commands) noexcept;

  /// Durations in recording order; call after the command buffer has completed. Valid until the next call.
  Result<std::span<const Pass>> read();

 private:
  struct Impl;
  explicit Timings(std::unique_ptr<Impl> impl) noexcept;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelagic
