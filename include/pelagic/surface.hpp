/// The surface stage: one watertight screen-space tessellated sheet from under the camera to the horizon.
#pragma once

#include <pelagic/camera.hpp>
#include <pelagic/waves.hpp>

namespace pelagic {

struct SurfaceInfo {
  /// Target length of a triangle's edge on screen [px], 2 … 64. Views of very high waves may get larger ones.
  float targetEdge = 12;
  /// Whether views leave WaterBuffer::motion, for temporal filters of the host.
  bool motionVectors = false;
  /// Radius of the planet at sea level [m], 1e5 … 1e8; Ocean gives it to the sky as well.
  double planetRadius = kEarthRadius;
};

/// What the surface leaves for shading: 2-D, one layer, one mip, of the view's extent; rests in kShaderRead.
struct WaterBuffer {
  /// rg32f: undisplaced (x,z) of the visible point minus the camera's (x,z) [m]. Where body is 0: undefined.
  MapView position;
  /// rg16f: screen motion since the previous record() of this view [uv], current minus previous position. 0 in the
  /// first frame. Where body is 0: undefined. Null without SurfaceInfo::motionVectors.
  MapView motion;
  /// r8ui: 0 no water, 1 the ocean.
  MapView body;
  /// d32f: depth as the camera's projection writes it; cleared to the far value.
  MapView depth;
  double planetRadius = kEarthRadius;  ///< As SurfaceInfo::planetRadius.
  /// Side of the sheet's cells on screen in the last record() [px]: SurfaceInfo::targetEdge, or more where a view
  /// needed larger ones. 0: the depth has whatever waves the pixels resolve.
  float cellEdge = 0;
};

/// Pipelines shared by all views. Move-only; one thread at a time.
class Surface {
 public:
  static Result<Surface> create(Device& device, const SurfaceInfo& info = {});
  Surface(Surface&&) noexcept;
  Surface& operator=(Surface&&) noexcept;
  ~Surface();

 private:
  friend class SurfaceView;
  struct Impl;
  explicit Surface(std::unique_ptr<Impl> impl) noexcept;
  std::unique_ptr<Impl> impl_;
};

/// One view's targets and geometry buffers. Move-only; must not outlive its Surface or the maps.
class SurfaceView {
 public:
  /// `maps`: of the simulation that is to be drawn, its `displacementPair` is what the view binds.
  /// `extent`: 1 … 16384 each.
  static Result<SurfaceView> create(Surface& surface, const WaveMaps& maps, VkExtent2D extent);
  SurfaceView(SurfaceView&&) noexcept;
  SurfaceView& operator=(SurfaceView&&) noexcept;
  ~SurfaceView();

  /// Tessellates and draws the sea of `maps`, as Waves::maps() returns them now. Not within rendering.
  void record(VkCommandBuffer commands, const WaveMaps& maps, const Camera& camera,
              Timings* timings = nullptr) noexcept;
  WaterBuffer buffer() const noexcept;
  /// Indirect draw arguments of the last record (VkDrawIndexedIndirectCommand first); usage includes TRANSFER_SRC.
  VkBuffer drawArguments() const noexcept;

 private:
  struct Impl;
  explicit SurfaceView(std::unique_ptr<Impl> impl) noexcept;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelagic
