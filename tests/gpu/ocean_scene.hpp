/// The built-in scenes, drawn as large and from where a test wants them.
#pragma once

#include <common/scene.hpp>
#include <functional>
#include <pelagic/ocean.hpp>
#include <vector>

#include "support/gpu_test.hpp"

namespace support {

/// Radiance and distance of every pixel.
struct Drawn {
  VkExtent2D extent{};
  std::vector<float> radiance;  ///< rgba
  std::vector<float> foam;      ///< Its cover.
  std::vector<float>
      depth;  ///< Reversed and infinite: 0.1 m over the distance along the axis; 0 where there is no water.

  glm::dvec3 at(std::uint32_t x, std::uint32_t y) const;
  double luminanceAt(std::uint32_t x, std::uint32_t y) const;
  double distanceAt(std::uint32_t x, std::uint32_t y) const;  ///< Along the axis [m].
};
double luminance(const glm::dvec3& radiance);

/// One scene and its views.
class OceanScene {
 public:
  /// `targetEdge`: of the sheet [px]; `change`: of the scene.
  OceanScene(const common::GpuDevice& gpu, pelagic::Device& device, const std::string& name, float targetEdge = 12,
             const std::function<void(common::Scene&)>& change = {}, const pelagic::GainMap& gain = {});

  /// Of a size that is drawn from now on.
  std::size_t addView(VkExtent2D extent);
  void setTime(double seconds);
  /// The scene as of the last setTime(), the camera rolled by `roll` [rad], to the left where it is positive.
  Drawn draw(std::size_t view, const common::View& from, double roll = 0);
  const common::Scene& scene() const { return scene_; }
  const pelagic::Ocean& ocean() const { return *ocean_; }

 private:
  struct Target {
    common::OwnedImage radiance, depth, normal;
    pelagic::OceanView view;
  };
  const common::GpuDevice* gpu_;
  common::Scene scene_;
  std::optional<pelagic::Ocean> ocean_;
  std::vector<Target> targets_;
};

/// From 8 m over the sea along the scene's own view, `turn` [rad] to the right of it and 2.3 degrees down, 45 degrees
/// high.
common::View fromAbove(const common::Scene& scene, double turn = 0);
/// Where the horizon is then, in parts of the picture's height.
inline constexpr double kHorizonFromAbove = 0.4536;

}  // namespace support
