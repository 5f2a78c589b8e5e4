/// What Waves and the classes that read its modes share.
#pragma once

#include <cmath>
#include <optional>
#include <pelagic/waves.hpp>
#include <waves/filter.hpp>
#include <waves/gain_image.hpp>
#include <waves/transform.hpp>

namespace pelagic {

/// The foam's clock: one tick takes one step of decay [s]. A loop has a whole number of ticks, of about this length.
inline constexpr double kFoamTick = kFoamLifetime / shader::kFoamSteps;

struct Waves::Impl {
  gpu::Context* context = nullptr;
  WavesInfo info;
  SeaChange sea;                    ///< As recorded last, or for the first time.
  std::optional<SeaChange> wanted;  ///< By setSea(), for the next record().
  double shown = 0;                 ///< Time recorded last [s].
  GainMap gain;                     ///< As recorded last, or for the first time.
  std::optional<GainMap> newGain;   ///< By setGain(), for the next record().
  double largestGain = 1;
  bool gainUploaded = false;
  WaveImages images;
  GainImage gainImage;
  WaveTransform transform;
  WaveFilter filter;
  std::uint32_t newest = 0;  ///< Of images.displacement.
  std::uint32_t slot = 0;    ///< Of the staging buffers.
  bool uploaded = false;
  std::uint64_t recordings = 0;  ///< Calls of record().
  bool hasFoam = false;
  double foamTick = 0;  ///< The last tick that the foam history holds, when hasFoam.

  double foamTickLength() const noexcept { return info.loopPeriod / std::round(info.loopPeriod / kFoamTick); }
  /// Ticks since the loop began.
  double foamClock(double time) const noexcept;
  const SeaChange& latest() const noexcept { return wanted ? *wanted : sea; }
  SeaMoment momentOf(double at) const noexcept {
    const double share = sea.share(at).value;
    return {loopFraction(at, info.loopPeriod), share < 1, static_cast<float>(share)};
  }
  void recordUpload(vk::CommandBuffer commands) noexcept;
  void clearFoam(vk::CommandBuffer commands) noexcept;
  void recordFoam(vk::CommandBuffer commands, double time) noexcept;
  void recordMaps(vk::CommandBuffer commands, double time, Timings* timings) noexcept;
};

}  // namespace pelagic
