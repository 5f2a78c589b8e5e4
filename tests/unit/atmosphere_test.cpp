#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <pelagic/sky.hpp>

#include "physics/atmosphere.glsl"

namespace {

namespace air = pelagic::shader;
constexpr double kPi = std::numbers::pi;

/// Midpoint rule.
double integral(double low, double high, int steps, const std::function<double(double)>& f) {
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += f(low + (high - low) * (i + 0.5) / steps);
  return sum * (high - low) / steps;
}

/// Altitude along a ray in double precision, from the law of cosines.
double altitude(double h, double mu, double t) {
  const double r = air::kEarthRadius + h;
  return std::sqrt(r * r + 2 * r * mu * t + t * t) - air::kEarthRadius;
}

/// Optical depth in double precision with its own densities and bounds; channel 0 to 2.
double opticalDepth(double h, double mu, double haze, double hazeHeight, int channel) {
  const double rayleigh[] = {7.10e-6, 1.38e-5, 3.31e-5};
  const double mie[] = {5.50e-5, 5.86e-5, 6.38e-5};
  const double ozone[] = {2.58e-6, 1.71e-6, 0};
  double end = 0;
  for (double step = 1e6; step > 1e-3; step /= 2) {
    if (altitude(h, mu, end + step) < 100e3) end += step;
  }
  return integral(0, end, 200000, [&](double t) {
    const double z = altitude(h, mu, t);
    return rayleigh[channel] * std::exp(-z / 8000) + haze * mie[channel] * std::exp(-z / hazeHeight) +
           ozone[channel] * std::max(0.0, 1 - std::abs(z - 25e3) / 15e3);
  });
}

TEST(Atmosphere, PhaseFunctionsIntegrateToOne) {
  const double rayleigh = 2 * kPi * integral(-1, 1, 1000, [](double mu) { return air::rayleighPhase(float(mu)); });
  const double mie = 2 * kPi * integral(-1, 1, 20000, [](double mu) { return air::miePhase(float(mu)); });
  EXPECT_NEAR(rayleigh, 1, 1e-5);
  EXPECT_NEAR(mie, 1, 1e-4);
  EXPECT_NEAR(air::rayleighPhase(1), 3 / (8 * kPi), 1e-6);
  EXPECT_GT(air::miePhase(1), 10 * air::miePhase(0));  // forward is mu = +1
}

TEST(Atmosphere, MeanCosineOfTheAerosolsIsThatOfSeaSalt) {
  const double mean = 2 * kPi * integral(-1, 1, 20000, [](double mu) { return mu * air::miePhase(float(mu)); });
  EXPECT_NEAR(mean, 0.76, 1e-4);
}

TEST(Atmosphere, VerticalOpticalDepthHasItsClosedForm) {
  for (const glm::vec2 haze : {glm::vec2(0, 1200), glm::vec2(1, 1200), glm::vec2(5, 1200), glm::vec2(4, 400)}) {
    const glm::vec3 depth = air::airOpticalDepth(0, 1, haze, 64);
    for (int c = 0; c < 3; ++c) {
      const double closed = double(air::kRayleighScattering[c]) * 8000 * (1 - std::exp(-12.5)) +
                            double(haze.x * air::kMieExtinction[c] * haze.y) + double(air::kOzoneAbsorption[c]) * 15000;
      EXPECT_NEAR(depth[c], closed, 0.003 * closed) << haze.x << ' ' << haze.y << ' ' << c;
    }
  }
}

TEST(Atmosphere, AerosolAndOzoneColumnsAreTheMeasuredOnes) {
  EXPECT_NEAR(double(air::kMieExtinction.y) * pelagic::SkyState{}.hazeHeight, 0.07, 0.001);
  // 300 Dobson units at the Rec.709 green's mean cross-section of 3.2e-25 m^2.
  EXPECT_NEAR(air::kOzoneAbsorption.y * 15000, 300 * 2.687e20 * 3.18e-25, 0.001);
}

TEST(Atmosphere, SlantOpticalDepthEqualsQuadrature) {
  for (const float hazeHeight : {1200.0f, 300.0f}) {
    for (const double h : {0.0, 500.0, 12000.0, 60000.0}) {
      for (const double degrees : {90.0, 45.0, 10.0, 2.0, 0.0, -1.0, -4.0}) {
        const double mu = std::sin(degrees * kPi / 180);
        if (mu < double(air::horizonCosine(float(h)))) continue;
        const glm::vec3 depth = air::airOpticalDepth(float(h), float(mu), {1, hazeHeight}, 40);
        for (int c = 0; c < 3; ++c) {
          const double expected = opticalDepth(h, mu, 1, static_cast<double>(hazeHeight), c);
          EXPECT_NEAR(depth[c], expected, 0.01 * expected + 1e-5)
              << hazeHeight << ' ' << h << ' ' << degrees << ' ' << c;
        }
      }
    }
  }
}

TEST(Atmosphere, RaysMeetTheGlobeWhereTheCosineLawSays) {
  for (const double h : {0.5, 3.0, 200.0, 50000.0}) {
    for (const double below : {0.002, 0.05, 0.5, 1.5}) {
      const double r = air::kEarthRadius + h;
      const double mu = -std::sin(std::acos(air::kEarthRadius / r) + below);
      const long double b = (long double)r * mu;
      const long double c = (long double)h * (2.0L * air::kEarthRadius + h);
      const double expected = double(c / (std::sqrt(b * b - c) - b));
      EXPECT_NEAR(air::distanceToGround(float(h), float(mu)), expected, 2e-4 * expected) << h << ' ' << below;
    }
    const double edge = air::horizonCosine(float(h));
    EXPECT_NEAR(std::asin(-edge), std::acos(air::kEarthRadius / (air::kEarthRadius + h)), 1e-6);
    EXPECT_LT(air::distanceToGround(float(h), float(edge + 1e-4)), 0);
  }
  EXPECT_LT(air::distanceToGround(10, 0.5f), 0);
  EXPECT_FLOAT_EQ(air::distanceToGround(10, -1), 10);
}

TEST(Atmosphere, DistanceToTheTopEndsAtTheTop) {
  for (const double h : {0.0, 10.0, 30000.0, 99000.0}) {
    for (const double mu : {1.0, 0.3, 0.01, 0.0, -0.02}) {
      const double t = air::distanceToTop(float(h), float(mu));
      EXPECT_NEAR(altitude(h, float(mu), t), 100e3, 2) << h << ' ' << mu;
    }
  }
}

TEST(Atmosphere, AltitudeKeepsCentimetresNearTheSea) {
  for (const double t : {1.0, 100.0, 10e3, 300e3}) {
    const long double r = 6371002.0L, mu = -2e-4f;
    const long double q = r * r + 2 * r * mu * t + (long double)t * t;
    const double expected = double(std::sqrt(q) - 6371000.0L);
    EXPECT_NEAR(air::altitudeAlong(2, -2e-4f, float(t)), expected, 0.01 + 1e-6 * t) << t;
  }
}

TEST(Atmosphere, MapParametrisationsInvert) {
  for (const float x : {0.0f, 0.05f, 0.3f, 0.7f, 0.97f, 1.0f}) {
    for (const float y : {0.0f, 0.1f, 0.5f, 0.9f}) {
      const glm::vec2 ray = air::transmittanceRay({x, y});
      const glm::vec2 place = air::transmittancePlace(ray.x, ray.y);
      EXPECT_NEAR(place.x, x, 2e-3) << x << ' ' << y;
      EXPECT_NEAR(place.y, y, 1e-4) << x << ' ' << y;
      const glm::vec2 point = air::scatteringPoint({x, y});
      const glm::vec2 back = air::scatteringPlace(point.x, point.y);
      EXPECT_NEAR(back.x, x, 1e-5);
      EXPECT_NEAR(back.y, y, 1e-5);
    }
  }
  for (const float edge : {0.0f, -0.056f}) {
    for (const float elevation : {-1.2f, -0.1f, 0.0f, 1e-3f, 0.5f, 1.5f}) {
      EXPECT_NEAR(air::skyElevation(air::skyRow(elevation, edge), edge), elevation, 1e-6);
    }
    EXPECT_NEAR(air::skyRow(edge, edge), 0.5, 1e-6);
    EXPECT_NEAR(air::skyRow(0.5f * air::kAirPi, edge), 1, 1e-6);
    EXPECT_NEAR(air::skyRow(-0.5f * air::kAirPi, edge), 0, 1e-6);
  }
}

TEST(Atmosphere, HorizonDipsByTheCosineLaw) {
  for (const double h : {0.0, 3.0, 200.0, 10e3, 60e3}) {
    for (const double radius : {1e5, 6371e3, 1e8}) {
      const double dip = std::acos(radius / (radius + h));
      const auto drawn = air::horizonElevation(static_cast<float>(h), static_cast<float>(radius));
      EXPECT_NEAR(drawn, -dip, 1e-5 + 1e-6 * dip) << h << " m over " << radius << " m";
    }
  }
}

TEST(Atmosphere, AzimuthOfTheMapTurnsFromXToZ) {
  EXPECT_NEAR(air::skyUv({1, 0, 0}).x, 0, 1e-6);
  EXPECT_NEAR(air::skyUv({0, 0, 1}).x, 0.25, 1e-6);
  EXPECT_NEAR(air::skyUv({0, 0, -1}).x, 0.75, 1e-6);
  EXPECT_NEAR(air::skyUv({0, 1, 0}).y, 1, 1e-6);
}

TEST(Atmosphere, OvercastSkyGivesSevenNinthsPi) {
  const double irradiance = 2 * kPi * integral(0, kPi / 2, 10000, [](double e) {
                              return air::cieOvercast(float(std::sin(e))) * std::sin(e) * std::cos(e);
                            });
  EXPECT_NEAR(irradiance, 7 * kPi / 9, 1e-5);
  EXPECT_FLOAT_EQ(air::cieOvercast(1), 1);
}

TEST(Atmosphere, DiscShareIsTheAreaAboveTheEdge) {
  const double radius = air::kSunAngularRadius;
  for (const double x : {-1.0, -0.6, 0.0, 0.3, 1.0}) {  // centre above the edge, in radii
    const double area = integral(-x, 1, 20000, [](double y) { return 2 * std::sqrt(std::max(0.0, 1 - y * y)); });
    EXPECT_NEAR(air::sunDiscShare(float(x * radius)), area / kPi, 1e-4) << x;
  }
  EXPECT_EQ(air::sunDiscShare(-0.1f), 0);
  EXPECT_EQ(air::sunDiscShare(0.1f), 1);
}

}  // namespace
