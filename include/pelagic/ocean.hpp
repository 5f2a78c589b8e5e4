/// The facade: every stage in one object, and a frame in one call.
#pragma once

#include <pelagic/composite.hpp>

namespace pelagic {

struct OceanInfo {
  WavesInfo waves;
  SkyState sky;
  SkyEnvironment environment;  ///< In place of the sky, where it has a width.
  SurfaceInfo surface;
  WaterMedium medium;
  std::vector<HostLight> lights;
};

class OceanView;

/// A whole ocean. Move-only; one thread at a time. The Device must outlive it.
class Ocean {
 public:
  static Result<Ocean> create(Device& device, const OceanInfo& info);
  Ocean(Ocean&&) noexcept;
  Ocean& operator=(Ocean&&) noexcept;
  ~Ocean();

  /// Each takes effect with the next record(). On error nothing changes.
  Result<void> setSea(const SeaState& sea, const SeaTransition& transition = {});
  Result<void> setGain(const GainMap& map);
  Result<void> setSky(const SkyState& sky);
  Result<void> setEnvironment(const SkyEnvironment& environment);
  Result<void> setMedium(const WaterMedium& medium);
  Result<void> setLights(std::span<const HostLight> lights);

  /// Binds the host's images of one view. The view must not outlive the ocean.
  Result<OceanView> createView(const CompositeTargets& targets);
  /// Advances sea and sky to `time` [s]; once per frame, before any view.
  void record(VkCommandBuffer commands, double time, Timings* timings = nullptr) noexcept;

  const Waves& waves() const noexcept;
  const Sky& sky() const noexcept;

 private:
  friend class OceanView;
  struct Impl;
  explicit Ocean(std::unique_ptr<Impl> impl) noexcept;
  std::unique_ptr<Impl> impl_;
};

/// One camera's picture of an Ocean. Move-only.
class OceanView {
 public:
  OceanView(OceanView&&) noexcept;
  OceanView& operator=(OceanView&&) noexcept;
  ~OceanView();

  /// Draws and shades the sea as of the ocean's last record().
  void record(VkCommandBuffer commands, const Camera& camera, Timings* timings = nullptr) noexcept;
  WaterBuffer waterBuffer() const noexcept;
  VkBuffer drawArguments() const noexcept;

 private:
  friend class Ocean;
  struct Impl;
  explicit OceanView(std::unique_ptr<Impl> impl) noexcept;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelagic
