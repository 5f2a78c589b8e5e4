/// The sea at single points, on the CPU: for buoys, hulls, cameras and whoever simulates without a GPU.
#pragma once

#include <optional>
#include <pelagic/waves.hpp>
#include <span>

namespace pelagic {

/// A point of the displaced surface.
struct SurfacePoint {
  glm::dvec3 position{0};      ///< (x, height, z) [m]; x and z are those asked for.
  glm::dvec2 undisplaced{0};   ///< (x, z) of the same water at rest [m].
  glm::dvec3 normal{0, 1, 0};  ///< Unit, upward unless the surface has folded over.
  /// Of the water that is here now (Lagrangian) [m/s], [m/s^2].
  glm::dvec3 velocity{0};
  glm::dvec3 acceleration{0};
};

/// Evaluates a sea on the CPU at any time, past or future, independent of any Device, camera or frame: the same modes
/// on the same lattice as the wave maps, linear between their texels, so that it agrees with 32-bit maps within 1e-4
/// Hs, and within 6e-4 Hs where warp and choppiness are largest. Move-only. setTime() is for one thread; the others
/// that are const may be called by many at a time.
class SeaQuery {
 public:
  /// `info`: as given to Waves; precision and framesInFlight are not used. Waves shorter than `shortestWavelength` [m],
  /// 0 … 1e4, are left out; cascades that hold only such cost nothing.
  static Result<SeaQuery> create(const WavesInfo& info, double shortestWavelength = 0);
  SeaQuery(SeaQuery&&) noexcept;
  SeaQuery& operator=(SeaQuery&&) noexcept;
  ~SeaQuery();

  /// Replaces the sea, as Waves::setSea(); the time stays. On error nothing changes.
  Result<void> setSea(const SeaState& sea, const SeaTransition& transition = {});
  /// Replaces the map of gains, as Waves::setGain(); any size.
  Result<void> setGain(const GainMap& map);
  /// Transforms the sea to `time` [s], any finite value in any order; free when it is the current one. Others change
  /// nothing. Starts at 0.
  void setTime(double time) noexcept;

  /// The surface vertically over or under (x, z) [m], finite, |x| and |z| <= 1e9. Where the surface folds over, the
  /// sheet that Newton's iteration reaches from the point itself.
  SurfacePoint at(const glm::dvec2& point) const noexcept;
  /// Height alone [m], which is cheaper.
  double heightAt(const glm::dvec2& point) const noexcept;
  /// Heights [m] of many points, sooner than one by one: as many as both hold, what is left of `heights` stays. NaN
  /// where a point is out of range.
  void heightsAt(std::span<const glm::dvec2> points, std::span<double> heights) const noexcept;
  /// First point where a ray meets the surface, from above or below, within `reach` [m] of its origin. `direction` need
  /// not be of unit length. None also when it is 0 or anything is not finite.
  std::optional<SurfacePoint> intersect(const glm::dvec3& origin, const glm::dvec3& direction,
                                        double reach) const noexcept;

 private:
  struct Impl;
  explicit SeaQuery(std::unique_ptr<Impl> impl) noexcept;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelagic
