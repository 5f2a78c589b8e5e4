/// The mean reflectance of a rough sea as a table, integrated from the exact Fresnel equations.
#pragma once

#include <vector>

namespace pelagic {

/// Mean of the exact reflectance over the slopes seen at `cosView` to the mean normal (seenSlopes() in
/// shaders/physics/ocean_brdf.glsl), for Gaussian slopes with the same `deviation` in every direction [1].
double meanFresnel(double cosView, double deviation);

/// kFresnelTableWidth x kFresnelTableHeight entries, row by row, laid out as physics/fresnel.glsl says.
std::vector<float> fresnelTable();

}  // namespace pelagic
