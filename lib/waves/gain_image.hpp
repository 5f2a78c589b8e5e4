/// A gain map on the device.
#pragma once

#include <gpu/barrier.hpp>
#include <pelagic/waves.hpp>

namespace pelagic {

/// r32f, one layer a cascade; its size is fixed. Empty without a map.
class GainImage {
 public:
  static Result<GainImage> create(gpu::Context& context, const WavesInfo& info);
  /// Copies the map through staging slot `slot`; the slot's last copy must have been executed.
  void upload(vk::CommandBuffer commands, const GainMap& map, std::uint32_t slot) noexcept;
  MapView map() const noexcept { return staging_.empty() ? MapView{} : image_.map(); }

 private:
  gpu::Context* context_ = nullptr;
  gpu::Image image_;
  std::vector<gpu::Buffer> staging_;
};

}  // namespace pelagic
