/// A sea of one known wave, cameras of every kind and the water buffer as plain numbers.
#pragma once

#include <common/gpu_device.hpp>
#include <glm/glm.hpp>
#include <pelagic/surface.hpp>
#include <random>

namespace surface_scene {

/// A travelling wave that fits a whole number of times into the patch: phase = 2 pi (mode . x) / kPatch + phase.
struct Wave {
  double amplitude = 0;   ///< [m]
  glm::ivec2 mode{1, 0};  ///< Waves per patch along x and z.
  double choppiness = 0;
  double phase = 0;  ///< [rad]
  /// (Dx, h, Dz) of the undisplaced point [m].
  glm::dvec3 at(const glm::dvec2& point) const;
  /// Height of the surface above or below a point of the plane, choppiness taken into account [m].
  double heightBelow(const glm::dvec2& point) const;
};

inline constexpr double kPatch = 400;  ///< [m]
inline constexpr std::uint32_t kSize = 256;

/// Wave maps with nothing but displacements, uploaded by the test.
class SyntheticSea {
 public:
  SyntheticSea(const common::GpuDevice& gpu, const Wave& now, const Wave& before);
  const pelagic::WaveMaps& maps() const { return maps_; }

 private:
  struct Map {
    vk::UniqueDeviceMemory memory;
    vk::UniqueImage image;
    vk::UniqueImageView view;
  };
  pelagic::MapView upload(const common::GpuDevice& gpu, const Wave& wave, Map& map);
  Map now_, before_;
  pelagic::WaveMaps maps_;
};

struct Lens {
  double fov = 1;       ///< Vertical field of view [rad].
  glm::dvec2 shift{0};  ///< Of the picture's centre, in half pictures.
  double near = 0.1;    ///< [m]
  double far = 0;       ///< [m], 0: infinite.
  bool reversed = true;
  bool flipped = true;  ///< Clip y points down.
};
/// Yaw from -z toward +x, pitch upward, roll [rad].
pelagic::Camera camera(const glm::dvec3& position, double yaw, double pitch, double roll, const Lens& lens,
                       VkExtent2D extent);

/// World direction through a point of the picture, (0, 0) … (1, 1), not normalised.
glm::dvec3 ray(const pelagic::Camera& camera, const glm::dvec2& uv);
/// Distance in units of `direction` to the sea level sphere raised by `level` [m] below the camera; negative: none.
double hitSphere(const pelagic::Camera& camera, const glm::dvec3& direction, double level = 0,
                 double planetRadius = pelagic::kEarthRadius);
/// Sea level at a point relative to the camera's foot [m].
double seaLevel(const glm::dvec2& relative);
/// Picture coordinates and depth of a point relative to the camera.
glm::dvec3 project(const pelagic::Camera& camera, const glm::dvec3& relative);

/// A water buffer read back.
struct Water {
  VkExtent2D extent{};
  std::vector<float> position, motion, body, depth;
  std::size_t index(std::uint32_t x, std::uint32_t y) const { return std::size_t(y) * extent.width + x; }
  bool covered(std::uint32_t x, std::uint32_t y) const { return body[index(x, y)] != 0; }
  glm::dvec2 uv(std::uint32_t x, std::uint32_t y) const {
    return {(x + 0.5) / extent.width, (y + 0.5) / extent.height};
  }
};
Water read(const common::GpuDevice& gpu, const pelagic::WaterBuffer& buffer);

}  // namespace surface_scene
