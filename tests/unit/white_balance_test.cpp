/// Whites of known light, and what makes them grey.
#include <gtest/gtest.h>

#include <composite/white_balance.hpp>

namespace {

using namespace pelagic;

// CIE 15: illuminant A, a black body of 2856 K, and daylight D50, D65 and D75, which have been 5003, 6504 and 7504 K
// since Planck's constant was measured better.
TEST(WhiteBalance, ChromaticityOfStandardIlluminants) {
  const struct {
    double kelvin, x, y;
  } known[] = {{2856, 0.44757, 0.40745}, {5003, 0.34567, 0.35850}, {6504, 0.31272, 0.32903}, {7504, 0.29902, 0.31485}};
  for (const auto& [kelvin, x, y] : known) {
    EXPECT_NEAR(whiteChromaticity(kelvin).x, x, 6e-4) << kelvin;
    EXPECT_NEAR(whiteChromaticity(kelvin).y, y, 6e-4) << kelvin;
  }
}

/// Linear sRGB of luminance 1 and a chromaticity, by the inverse of IEC 61966-2-1's matrix as it is published.
glm::dvec3 rgbOf(const glm::dvec2& c) {
  const glm::dvec3 xyz(c.x / c.y, 1, (1 - c.x - c.y) / c.y);
  return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
          -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
          0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

TEST(WhiteBalance, ItsWhiteBecomesGreyOfTheSameLuminance) {
  for (const double kelvin : {2000.0, 2856.0, 4000.0, 4500.0, 5003.0, 6504.0, 9000.0, 25000.0}) {
    const glm::dvec3 grey = whiteBalance(kelvin) * rgbOf(whiteChromaticity(kelvin));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(grey[c], 1, 1e-3) << kelvin;
  }
}

// Bradford's D50 to D65 as it is published (Lindbloom), on a colour that is not white.
TEST(WhiteBalance, IsBradfords) {
  const glm::dvec3 rgb(0.8, 0.3, 0.1);
  const glm::dvec3 xyz(0.4124564 * 0.8 + 0.3575761 * 0.3 + 0.1804375 * 0.1,
                       0.2126729 * 0.8 + 0.7151522 * 0.3 + 0.0721750 * 0.1,
                       0.0193339 * 0.8 + 0.1191920 * 0.3 + 0.9503041 * 0.1);
  const glm::dvec3 adapted(0.9555766 * xyz.x - 0.0230393 * xyz.y + 0.0631636 * xyz.z,
                           -0.0282895 * xyz.x + 1.0099416 * xyz.y + 0.0210077 * xyz.z,
                           0.0122982 * xyz.x - 0.0204830 * xyz.y + 1.3299098 * xyz.z);
  const glm::dvec3 expected(3.2404542 * adapted.x - 1.5371385 * adapted.y - 0.4985314 * adapted.z,
                            -0.9692660 * adapted.x + 1.8760108 * adapted.y + 0.0415560 * adapted.z,
                            0.0556434 * adapted.x - 0.2040259 * adapted.y + 1.0572252 * adapted.z);
  const glm::dvec3 balanced = whiteBalance(5003) * rgb;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(balanced[c], expected[c], 2e-3) << c;
}

TEST(WhiteBalance, DaylightStaysAsItIs) {
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) EXPECT_NEAR(whiteBalance(6504)[c][r], c == r, 1e-12);
  }
}

// Also where one formula hands over to the next: black bodies change by 2.3e-4 in a step.
TEST(WhiteBalance, IsSteady) {
  for (double kelvin = 2000; kelvin < 25000; kelvin *= 1.001) {
    EXPECT_LT(glm::distance(whiteChromaticity(kelvin), whiteChromaticity(kelvin * 1.001)), 4e-4) << kelvin;
  }
}

}  // namespace
