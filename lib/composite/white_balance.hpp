/// The white balance of a picture.
#pragma once

#include <glm/glm.hpp>

namespace pelagic {

/// Chromaticity (CIE 1931 x, y) of white of a colour temperature [K], 2000 … 25000: of a black body below 4000 K (Kim
/// et al. 2002), of daylight above (CIE 15, D series), between 4000 and 5000 K from one to the other.
glm::dvec2 whiteChromaticity(double kelvin) noexcept;

/// What turns linear sRGB such that white of this temperature becomes grey: the Bradford transform to D65. 6504 K is
/// the identity.
glm::dmat3 whiteBalance(double kelvin) noexcept;

}  // namespace pelagic
