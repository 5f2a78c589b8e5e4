/// A sea and a sky made of constants, so that what the composite stage makes of them has a closed form.
#pragma once

#include <optional>
#include <pelagic/composite.hpp>

#include "pelagic/shader/sky_light.h"
#include "support/gpu_test.hpp"

namespace support {

/// Everything that CompositeView takes, of one size. Set the members, then render().
class SyntheticScene {
 public:
  SyntheticScene(const common::GpuDevice& gpu, vk::Extent2D extent);

  vk::Extent2D extent;
  /// Per pixel.
  std::vector<std::uint8_t> body;
  std::vector<glm::vec2> position;  ///< Undisplaced, from the eye [m].
  std::vector<float> depth;
  std::vector<float> hostDepth;
  std::array<float, 4> gradient{0, 0, 0, 0};
  std::array<float, 4> moments{0, 0, 0, 0};
  float foam = 0;
  std::array<float, 4> sky{0.2f, 0.3f, 0.4f, 1};
  const pelagic::Sky* realSky = nullptr;  ///< Its maps are used instead, `light` stays.
  std::array<float, 4> hostColor{7, 8, 9, 1};
  pelagic::shader::SkyLight light{};
  pelagic::WaveMaps waves;
  pelagic::Camera camera;
  pelagic::WaterMedium medium;
  std::vector<pelagic::HostLight> lights;
  double planetRadius = pelagic::kEarthRadius;
  bool withHost = false;
  bool airBeforeHost = true;
  std::optional<std::array<float, 4>> clouds;  ///< The same before every pixel; their shadow on the sea is their red.
  bool withOutputs = true;

  /// Fills the whole view with water at the axial distance w [m].
  void fillWater(float w);
  /// Lets pixels lie `step` apart on the undisplaced sea [m].
  void spread(float step);
  float depthAt(float w) const;
  void render(pelagic::Device& device);

  // After render(): four, four, two and one float a pixel.
  std::vector<float> radiance, normal, slopeVariance, mergedDepth;
  glm::vec3 radianceAt(std::uint32_t x, std::uint32_t y) const;
  /// Unit direction from the eye through a pixel.
  glm::dvec3 directionAt(std::uint32_t x, std::uint32_t y) const;

 private:
  void createImages();
  void upload();
  void fillMaps();
  const common::GpuDevice* gpu_;
  common::OwnedImage gradientImage_, momentsImage_, foamImage_, radianceImage_, environmentImage_, cloudImage_;
  common::OwnedImage positionImage_, bodyImage_, depthImage_, hostColorImage_, hostDepthImage_;
  common::OwnedImage output_, normalImage_, varianceImage_, mergedImage_;
  vk::UniqueImageView gradientView_, momentsView_, foamView_;
  vk::UniqueDeviceMemory lightMemory_;
  vk::UniqueBuffer lightBuffer_;
  pelagic::SkyMaps skyMaps_;
  pelagic::WaterBuffer water_;
};

/// Perspective with an infinite far plane, y down in clip space; depth 1 … 0 (reversed) or 0 … 1.
glm::mat4 perspective(double verticalAngle, double aspect, double near, bool reversed);
/// World-to-view rotation of a camera that looks along `yaw` (from -z toward +x) and down by `pitch` [rad].
glm::mat3 lookAlong(double yaw, double pitch);

}  // namespace support
