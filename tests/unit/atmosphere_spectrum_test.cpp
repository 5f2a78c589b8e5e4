// The atmosphere's three channels against its spectrum: the coefficients are means over Rec.709's colour matching
// functions, which is exact for thin air only; these tests say how far it carries.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "physics/atmosphere.glsl"

namespace {

namespace air = pelagic::shader;
using glm::dvec3;

/// CIE 1931 colour matching functions, the multi-lobe fit of Wyman, Sloan & Shirley (2013); l in nm.
dvec3 colourMatching(double l) {
  const auto lobe = [l](double mean, double below, double above) {
    const double t = (l - mean) * (l < mean ? below : above);
    return std::exp(-0.5 * t * t);
  };
  return {
      1.056 * lobe(599.8, 0.0264, 0.0323) + 0.362 * lobe(442.0, 0.0624, 0.0374) - 0.065 * lobe(501.1, 0.0490, 0.0382),
      0.821 * lobe(568.8, 0.0213, 0.0247) + 0.286 * lobe(530.9, 0.0613, 0.0322),
      1.217 * lobe(437.0, 0.0845, 0.0278) + 0.681 * lobe(459.0, 0.0385, 0.0725)};
}

double rayleigh(double l) { return 1.3558e-5 * std::pow(550 / l, 4.08); }
double aerosol(double l) { return 5.86e-5 * std::pow(550 / l, 0.4); }

/// Mean absorption of 300 Dobson units in a layer of 15 km [1/m]: cross-sections of the Chappuis band in 1e-21 cm^2,
/// every 20 nm from 440 nm.
double ozone(double l) {
  constexpr double kSections[] = {0.125, 0.35, 0.75, 1.2, 1.8, 2.95, 3.9, 4.6, 5.05, 4.0, 2.85, 2.05, 1.35, 0.85};
  const double x = std::clamp((l - 440) / 20, 0.0, 13.0);
  const auto i = std::min(static_cast<std::size_t>(x), std::size(kSections) - 2);
  const double section = kSections[i] + (kSections[i + 1] - kSections[i]) * (x - static_cast<double>(i));
  return section * 1e-25 * 8.06e22 / 15000;  // m^2 x molecules per m^2
}

/// What Rec.709 sees of `spectrum` x a 5778 K sun, relative to the sun.
dvec3 seen(const std::function<double(double)>& spectrum) {
  dvec3 sum(0), white(0);
  for (double l = 380; l <= 780; ++l) {
    const double sun = std::pow(l, -5) / (std::exp(1.4388e7 / (l * 5778)) - 1);
    sum += sun * spectrum(l) * colourMatching(l);
    white += sun * colourMatching(l);
  }
  const auto rec709 = [](const dvec3& c) {
    return dvec3(3.2406 * c.x - 1.5372 * c.y - 0.4986 * c.z, -0.9689 * c.x + 1.8758 * c.y + 0.0415 * c.z,
                 0.0557 * c.x - 0.2040 * c.y + 1.0570 * c.z);
  };
  return rec709(sum) / rec709(white);
}

TEST(AtmosphereSpectrum, ThinAirHasTheSpectrumsColours) {
  const dvec3 molecules = seen(rayleigh), particles = seen(aerosol), absorber = seen(ozone);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(air::kRayleighScattering[c], molecules[c], 0.01 * molecules[c]) << c;
    EXPECT_NEAR(air::kMieExtinction[c], particles[c], 0.01 * particles[c]) << c;
    // Blue would be a little below zero: the colours of the Chappuis band lie outside of Rec.709.
    EXPECT_NEAR(air::kOzoneAbsorption[c], absorber[c], 1.2e-7) << c;
  }
}

TEST(AtmosphereSpectrum, SunlightKeepsItsColourDownToFiveDegrees) {
  for (const double airMass : {1.0, 2.0, 5.5, 10.0}) {
    const dvec3 exact = seen(
        [&](double l) { return std::exp(-airMass * (rayleigh(l) * 8000 + aerosol(l) * 1200 + ozone(l) * 15000)); });
    for (int c = 0; c < 3; ++c) {
      const double three =
          std::exp(-airMass * (double(air::kRayleighScattering[c]) * 8000 + double(air::kMieExtinction[c]) * 1200 +
                               double(air::kOzoneAbsorption[c]) * 15000));
      EXPECT_NEAR(three, exact[c], 0.05 * exact[c] + 0.003) << airMass << ' ' << c;
    }
  }
}

}  // namespace
