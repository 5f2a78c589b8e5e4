/// What the facets of a rough sea mirror, as a table integrated from the exact Fresnel equations.
#pragma once

#include <glm/fwd.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace pelagic {

/// Of the facets in sight (sightOf() in shaders/physics/ocean_brdf.glsl), each counted by its reflectance.
struct ReflectingFacets {
  double reflectance;  ///< Mean [1].
  double facing;       ///< Mean of X over that of the mean facet, in deviations of X.
  double variance;     ///< Of X, in squares of them.
};

/// Seen at `cosView` to the mean normal, for Gaussian slopes with the same `deviation` in every direction [1].
ReflectingFacets reflectingFacets(double cosView, double deviation);

/// The same as halves, kFresnelTableWidth x kFresnelTableHeight of them, row by row, laid out as physics/fresnel.glsl
/// says.
std::vector<glm::u16vec4> fresnelTable();

}  // namespace pelagic
