/// The sea at single points, on the GPU: many at a time, answered a frame or more later.
#pragma once

#include <optional>
#include <pelagic/query.hpp>
#include <span>

namespace pelagic {

struct PointQueryInfo {
  /// Most points or rays of one call, 1 … 1e6.
  std::uint32_t capacity = 1024;
  /// Calls whose results are kept at a time, 1 … 16: calls of record() and recordRays() a frame, times the frames in
  /// flight.
  std::uint32_t callsInFlight = 2;
  /// Whether velocity and acceleration are asked for; without, both are 0. They are transformed anew after every
  /// Waves::record() that is asked about, which costs nearly as much as that.
  bool motion = true;
};

/// A ray, from above the sea or below.
struct SurfaceRay {
  glm::dvec3 origin{0};            ///< [m]
  glm::dvec3 direction{0, -1, 0};  ///< Of any length but 0.
  double reach = 1e4;              ///< How far it goes from the origin [m], 0 or more.
};

/// Evaluates a sea on the GPU: what SeaQuery of all wavelengths answers on the CPU, on the same lattice, with the same
/// interpolation in 32 bits and the same choice of a sheet where the surface folds over. Velocity and acceleration are
/// those of the water that is there now (Lagrangian), not of the place.
///
/// Bounds against SeaQuery, tested over 1e5 points of each of five seas, 10000 km from the origin after 30 days:
/// heights within 1e-4 Hs of maps of MapPrecision::single, 1e-3 Hs of MapPrecision::half; normals within 1e-3, and
/// 0.05; the error of velocities 1e-4 of their root mean square, and 1e-3; of accelerations 1e-3, and 2e-2.
///
/// Nothing waits: a call is recorded into a command buffer of the host, and read() gives its results when that has been
/// executed, which a host knows from its fence: with n frames in flight, n frames later. Move-only; one thread at a
/// time.
class PointQuery {
 public:
  /// `waves`: the sea; must outlive this, but may be moved.
  static Result<PointQuery> create(Device& device, const Waves& waves, const PointQueryInfo& info = {});
  PointQuery(PointQuery&&) noexcept;
  PointQuery& operator=(PointQuery&&) noexcept;
  ~PointQuery();

  /// Records the surface vertically over or under each of `points`, (x, z) [m], |x| and |z| <= 1e9, as of the last
  /// Waves::record(), which must have been recorded before, into this command buffer or an earlier one; not within
  /// rendering. Allocates nothing, unless it fails. Returns a ticket for read().
  Result<std::uint64_t> record(VkCommandBuffer commands, std::span<const glm::dvec2> points);
  /// The same for where rays first meet the surface. A ray is followed for at most 4096 steps of half a cell of the
  /// finest cascade, or of what lies between it and the sea where that is more. Its place is kept in 32 bits from where
  /// it enters the height of the waves: where it meets them is exact to 1e-6 of the way from there.
  Result<std::uint64_t> recordRays(VkCommandBuffer commands, std::span<const SurfaceRay> rays);

  /// Results of record() in the order of its points; of points that are not finite or too far away as SeaQuery::at().
  /// Call after the command buffer has been executed. A ticket is good until callsInFlight more calls are recorded, any
  /// number of times; errors name what is wrong with one that is not.
  Result<void> read(std::uint64_t ticket, std::span<SurfacePoint> results) const;
  /// Results of recordRays(): none where a ray meets nothing.
  Result<void> readRays(std::uint64_t ticket, std::span<std::optional<SurfacePoint>> results) const;

 private:
  struct Impl;
  explicit PointQuery(std::unique_ptr<Impl> impl) noexcept;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelagic
