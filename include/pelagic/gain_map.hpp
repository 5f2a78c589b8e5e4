/// Waves that are higher here than there: gusts, slicks, the lee of an island.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <pelagic/result.hpp>
#include <vector>

namespace pelagic {

/// Gain on the amplitude of each cascade's waves over the world, linear between samples that lie on a grid along x and
/// z; beyond it that of its edge. It should vary slowly, over more than the waves' length: what it does to a wave is
/// kinematic, no energy travels. The same gain acts on the drawn surface, its slopes and foam, and on queries; what the
/// gain's own slope adds to the waves' is in queries and left out of shading. Motion vectors of the frame in which a
/// map changes take the new gain for both frames.
struct GainMap {
  glm::dvec2 origin{0};      ///< World (x, z) of the first sample [m], |x| and |z| <= 1e9.
  double spacing = 100;      ///< Of the samples [m], 0.1 … 1e6.
  std::uint32_t width = 0;   ///< Samples along x, 2 … 4096; 0: no map, every gain is 1.
  std::uint32_t height = 0;  ///< Samples along z, 2 … 4096; 0 where width is.
  std::uint32_t bands = 0;   ///< 1: one gain for all cascades; or as many as there are cascades, longest waves first.
  std::vector<float> gains;  ///< [1], 0 … 4; band by band, in each row by row along z: width x height x bands.
};

/// Checks every field, for a layout of `cascades`. The error names the field, its value and its range.
Result<void> validate(const GainMap& map, std::uint32_t cascades);

}  // namespace pelagic
