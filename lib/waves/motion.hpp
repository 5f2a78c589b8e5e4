/// How the water moves, on the lattice: the derivatives in time of the displacement, for queries.
#pragma once

#include <waves/transform.hpp>

namespace pelagic {

class WaveMotion {
 public:
  static Result<WaveMotion> create(gpu::Context& context, WaveTransform& transform, double loopPeriod);

  /// Transforms the motion at `fraction` of the loop; between other uses of the transform's rows.
  void record(vk::CommandBuffer commands, std::uint64_t fraction, bool changing, const Share& share) noexcept;
  /// See motion_columns.comp; readable by compute after record().
  const gpu::Buffer& texels() const noexcept { return texels_; }

 private:
  gpu::Context* context_ = nullptr;
  WaveTransform::Shared modes_{};
  float radiansPerCycle_ = 0;
  gpu::Buffer texels_;
  std::array<gpu::ComputePass, 2> rows_;  ///< [whether the sea changes]
  gpu::ComputePass columns_;
  gpu::DescriptorSet rowsSet_, columnsSet_;
};

}  // namespace pelagic
