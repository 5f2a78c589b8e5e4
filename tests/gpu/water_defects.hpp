/// What a picture of the sea must not show.
#pragma once

#include "surface_scene.hpp"

namespace surface_scene {

/// Heights between which all water lies [m].
struct Layer {
  double bottom = 0;
  double top = 0;
};
/// Sums of the cascades' extremes, which no point of the sea exceeds.
Layer layerOf(const common::GpuDevice& gpu, const pelagic::WaveMaps& maps);

/// Whether every ray around a pixel meets the sphere raised by `level`, so that water must be seen there when the eye
/// and that sphere lie on different sides of the surface.
bool mustShowWater(const pelagic::Camera& camera, const glm::dvec2& uv, VkExtent2D extent, double level);

/// Numbers of pixels.
struct Defects {
  int holes = 0;  ///< No water where every ray around leaves the layer of the water on its other side.
  int above = 0;  ///< Water where no ray around meets the highest crest; not counted for an eye among the crests.
  /// Pixels of patches without water that are enclosed by water and of patches of water that are enclosed by air; and
  /// of water that is a fifth farther than all eight pixels around, as seen through a crack in a crest before it.
  int cracks = 0;

  int judgedWater = 0, judgedAir = 0;  ///< Pixels that could have been holes, or above.
};
/// `below`: the eye is under water.
Defects defectsOf(const Water& water, const pelagic::Camera& camera, const Layer& layer, bool below);

}  // namespace surface_scene
