/// Modes to maps: the passes that evolve, transform and assemble, and the foam's clock.
#pragma once

#include <gpu/barrier.hpp>
#include <gpu/compute_pass.hpp>
#include <waves/sea_change.hpp>

namespace pelagic {

/// The images that transform and filter write.
struct WaveImages {
  std::array<gpu::Image, 2> displacement;
  gpu::Image gradient, moments, foam;
};
Result<WaveImages> createWaveImages(gpu::Context& context, const WavesInfo& info);

/// The sea at a time.
struct SeaMoment {
  std::uint64_t fraction = 0;  ///< Of the loop.
  bool changing = false;
  float share = 1;  ///< Of the sea that comes.
};

class WaveTransform {
 public:
  static Result<WaveTransform> create(gpu::Context& context, const WavesInfo& info, const WaveImages& images);

  /// Copies the sea through staging slot `slot`; the slot's last copy must have been executed.
  void upload(vk::CommandBuffer commands, const SeaChange& sea, std::uint32_t slot) noexcept;
  /// Advances the foam by one tick of its clock. `keep`: the history holds the tick before.
  void recordFoamTick(vk::CommandBuffer commands, const SeaMoment& moment, bool keep) noexcept;
  /// The row pass of both planes.
  void recordRows(vk::CommandBuffer commands, const SeaMoment& moment) noexcept;
  /// The column pass: the finest mip of displacement[target] and the other maps, all in GENERAL layout.
  /// `fade`: decay of the foam since the last tick, 0 ... 1 / kFoamSteps.
  void recordColumns(vk::CommandBuffer commands, const SeaMoment& moment, std::uint32_t target, float fade) noexcept;

  /// For further passes over the same modes.
  struct Shared {
    vk::BufferView amplitudes, constants, planesView;
    const gpu::Buffer* cascades;
    gpu::Buffer* planes;  ///< Of the rows; nothing in them lasts from one record to the next.
    std::uint32_t size, count, band, rowsPerGroup, columnsPerGroup;
  };
  Shared shared() noexcept {
    return {*amplitudesView_, *constantsView_, *planesView_,  &cascades_,      &planes_, size_,
            count_,           band_,           rowsPerGroup_, columnsPerGroup_};
  }

 private:
  Result<void> createBuffers(gpu::Context& context, const WavesInfo& info);
  Result<void> createPasses(gpu::Context& context, const WavesInfo& info);
  Result<void> createSets(const WaveImages& images);
  void recordRowPass(vk::CommandBuffer commands, const gpu::ComputePass& pass, std::uint32_t cascades,
                     const SeaMoment& moment) noexcept;

  gpu::Context* context_ = nullptr;
  std::uint32_t size_ = 0;
  std::uint32_t count_ = 0;
  std::uint32_t foamCascades_ = 0;
  std::uint32_t band_ = 0;
  std::uint32_t rowsPerGroup_ = 0;
  std::uint32_t columnsPerGroup_ = 0;
  std::vector<gpu::Buffer> staging_;
  gpu::Buffer cascades_, amplitudes_, constants_, planes_;
  std::array<gpu::Buffer, 2> history_;
  std::uint32_t newest_ = 0;  ///< Of history_.
  gpu::Unique<vk::BufferView> amplitudesView_, constantsView_, planesView_;
  /// [whether the sea changes]
  std::array<gpu::ComputePass, 2> rows_, foamRows_;
  gpu::ComputePass columns_, foam_;
  gpu::DescriptorSet rowsSet_;
  /// [displacement target][newest history]
  std::array<std::array<gpu::DescriptorSet, 2>, 2> columnsSets_;
  /// [newest history]
  std::array<gpu::DescriptorSet, 2> foamSets_;
};

}  // namespace pelagic
