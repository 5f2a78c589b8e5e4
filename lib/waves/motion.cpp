#include "motion.hpp"

#include <shared/query.h>

#include <numbers>

#include "waves_motion_columns.spv.hpp"
#include "waves_motion_rows.spv.hpp"

namespace pelagic {

using vk::DescriptorType;

Result<WaveMotion> WaveMotion::create(gpu::Context& context, WaveTransform& transform, double loopPeriod) {
  WaveMotion result;
  result.context_ = &context;
  result.modes_ = transform.shared();
  result.radiansPerCycle_ = static_cast<float>(2 * std::numbers::pi / loopPeriod);
  const WaveTransform::Shared& modes = result.modes_;
  const vk::DeviceSize bytes = 2 * sizeof(glm::vec4) * vk::DeviceSize{modes.size} * modes.size * modes.count;
  const vk::DeviceSize most = context.properties.limits.maxStorageBufferRange;
  if (bytes > most) {
    return gpu::reject("the motion of this layout needs a storage buffer of " + std::to_string(bytes) +
                           " bytes, the device has " + std::to_string(most),
                       ErrorCode::unsupported);
  }
  PELAGIC_TRY(texels, gpu::Buffer::create(context, Stage::waves, "waves motion", bytes,
                                          vk::BufferUsageFlagBits::eStorageBuffer));
  result.texels_ = std::move(texels);

  const gpu::Binding rowBindings[] = {{0, DescriptorType::eUniformTexelBuffer},
                                      {1, DescriptorType::eUniformTexelBuffer},
                                      {2, DescriptorType::eStorageBuffer},
                                      {3, DescriptorType::eStorageBuffer}};
  const gpu::Binding columnBindings[] = {{0, DescriptorType::eUniformTexelBuffer},
                                         {1, DescriptorType::eStorageBuffer},
                                         {2, DescriptorType::eStorageBuffer}};
  const std::uint32_t threads = modes.size / shader::kSamplesPerThread;
  for (std::uint32_t changing = 0; changing < 2; ++changing) {
    const std::uint32_t constants[] = {threads, modes.rowsPerGroup, modes.band, 0, changing};
    PELAGIC_TRY(rows, gpu::ComputePass::create(context, {"waves motion rows", shaders::waves_motion_rows, rowBindings,
                                                         sizeof(shader::WaveMotionPush), constants}));
    result.rows_[changing] = std::move(rows);
  }
  const std::uint32_t constants[] = {modes.columnsPerGroup, threads, modes.band};
  PELAGIC_TRY(columns, gpu::ComputePass::create(context, {"waves motion columns", shaders::waves_motion_columns,
                                                          columnBindings, 0, constants}));
  result.columns_ = std::move(columns);
  PELAGIC_TRY(rowsSet, result.rows_[0].createSet("waves motion rows"));
  rowsSet.texelBuffer(0, modes.amplitudes);
  rowsSet.texelBuffer(1, modes.constants);
  rowsSet.buffer(2, modes.cascades->handle());
  rowsSet.buffer(3, modes.planes->handle());
  result.rowsSet_ = std::move(rowsSet);
  PELAGIC_TRY(columnsSet, result.columns_.createSet("waves motion columns"));
  columnsSet.texelBuffer(0, modes.planesView);
  columnsSet.buffer(1, modes.cascades->handle());
  columnsSet.buffer(2, result.texels_.handle());
  result.columnsSet_ = std::move(columnsSet);
  return result;
}

void WaveMotion::record(vk::CommandBuffer commands, std::uint64_t fraction, bool changing,
                        const Share& share) noexcept {
  gpu::Barrier()
      .buffer(*modes_.planes, gpu::kComputeWrite)
      .buffer(texels_, gpu::kComputeWrite)
      .record(*context_, commands);
  const gpu::ComputePass& rows = rows_[changing];
  rows.bind(commands, rowsSet_);
  rows.push(commands,
            shader::WaveMotionPush{static_cast<std::uint32_t>(fraction >> 32), static_cast<std::uint32_t>(fraction),
                                   static_cast<float>(share.value), static_cast<float>(share.rate),
                                   static_cast<float>(share.acceleration), radiansPerCycle_});
  rows.dispatch(commands, 1, gpu::groups(2 * modes_.band, modes_.rowsPerGroup), 2 * modes_.count);
  gpu::Barrier().buffer(*modes_.planes, gpu::kComputeTexelRead).record(*context_, commands);
  columns_.bind(commands, columnsSet_);
  columns_.dispatch(commands, modes_.size / modes_.columnsPerGroup, 1, 2 * modes_.count);
  gpu::Barrier().buffer(texels_, gpu::kComputeRead).record(*context_, commands);
}

}  // namespace pelagic
