/// The sky of planets that are smaller or larger than the Earth.
#include <cmath>
#include <numbers>

#include "sky_fixture.hpp"

namespace {

using glm::dvec3;
constexpr double kPi = std::numbers::pi;
constexpr double kTop = 100e3;  // of the air [m]

/// The Earth's air around a planet, in double precision, densities and coefficients written out again. Rays start at
/// the altitude h [m], mu is the sine of their elevation.
struct Air {
  double radius;  ///< [m]
  double haze;

  double altitudeAlong(double h, double mu, double t) const {
    const double r = radius + h;
    return std::sqrt(r * r + 2 * r * mu * t + t * t) - radius;
  }
  double distanceToTop(double h, double mu) const {
    const double r = radius + h, top = radius + kTop;
    return -r * mu + std::sqrt(r * r * (mu * mu - 1) + top * top);
  }
  dvec3 opticalDepth(double h, double mu, double end, int steps) const {
    dvec3 depth(0);
    for (int i = 0; i < steps; ++i) {
      const double z = altitudeAlong(h, mu, end * (i + 0.5) / steps);
      depth += end / steps *
               (dvec3(7.10e-6, 1.38e-5, 3.31e-5) * std::exp(-z / 8000) +
                haze * dvec3(5.50e-5, 5.86e-5, 6.38e-5) * std::exp(-z / 1200) +
                dvec3(2.58e-6, 1.71e-6, 0) * std::max(0.0, 1 - std::abs(z - 25e3) / 15e3));
    }
    return depth;
  }
  /// Sunlight that molecules scatter once, toward the eye, from a direction at a right angle to the sun's azimuth.
  dvec3 scatteredOnce(double h, double elevation, double sunElevation) const {
    const double mu = std::sin(elevation), sunMu = std::sin(sunElevation), angle = mu * sunMu;
    const double end = distanceToTop(h, mu);
    constexpr int kSteps = 1500;
    dvec3 light(0), depth(0);
    for (int i = 0; i < kSteps; ++i) {
      const double t = end * (i + 0.5) / kSteps, z = altitudeAlong(h, mu, t);
      const double sunThere = ((radius + h) * sunMu + t * angle) / (radius + z);
      const dvec3 scattering = dvec3(7.10e-6, 1.38e-5, 3.31e-5) * std::exp(-z / 8000);
      const dvec3 step =
          end / kSteps * (scattering + dvec3(2.58e-6, 1.71e-6, 0) * std::max(0.0, 1 - std::abs(z - 25e3) / 15e3));
      const dvec3 toSun = opticalDepth(z, sunThere, distanceToTop(z, sunThere), 400);
      light += scattering * glm::exp(-depth - 0.5 * step - toSun) * (end / kSteps);
      depth += step;
    }
    return 3 / (16 * kPi) * (1 + angle * angle) * light;
  }
};

using SkyPlanetTest = support::SkyFixture;

TEST_F(SkyPlanetTest, SunlightComesThroughTheAirOfThatPlanet) {
  for (const double radius : {1e5, 1737e3, 1e8}) {
    for (const double elevation : {0.03, 0.2, 0.8}) {
      pelagic::Sky sky = createSky({elevation, 0, 0, 1, {}}, radius);
      gpu().run([&](vk::CommandBuffer commands) { sky.record(commands, 0); });
      const glm::vec4 sunlight = light(sky.maps()).sunIrradiance;
      const Air air{radius, 1};
      const double mu = std::sin(elevation);
      const dvec3 expected = glm::exp(-air.opticalDepth(0, mu, air.distanceToTop(0, mu), 20000));
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(sunlight[c], expected[c], 0.01 * expected[c] + 1e-4) << radius << ' ' << elevation;
      }
    }
  }
}

/// Light scattered more often adds a tenth to three.
TEST_F(SkyPlanetTest, RowsAreCountedFromItsHorizon) {
  const double sun = kPi / 3;
  for (const double radius : {1e5, 1737e3, 1e8}) {
    const Air air{radius, 0};
    pelagic::Sky sky = createSky({sun, 0, 0, 0, {}}, radius);
    pelagic::SkyView seen = createView(sky, {16, 16});
    for (const double altitude : {0.0, 9000.0}) {
      gpu().run([&](vk::CommandBuffer commands) {
        sky.record(commands, 0);
        seen.record(commands, cameraAt(altitude));
      });
      const support::SkyMap map = read(seen.maps().radiance);
      const double edge = -std::acos(radius / (radius + altitude));
      for (const int row : {1, 8, 60, 126}) {
        const double s = (row + 0.5) / (0.5 * map.height), elevation = edge + (kPi / 2 - edge) * s * s;
        const double seenThere = map.at(map.width / 4, map.height / 2 + row).r;
        const double ratio = seenThere / air.scatteredOnce(altitude, elevation, sun).r;
        EXPECT_GT(ratio, 1.05) << radius << " m, from " << altitude << " m, row " << row;
        EXPECT_LT(ratio, 1.35) << radius << " m, from " << altitude << " m, row " << row;
      }
    }
  }
}

/// From 3 m the horizon of a planet of 100 km lies 0.44 degrees down, the Earth's 0.06.
TEST_F(SkyPlanetTest, CloudsReachDownToItsHorizon) {
  constexpr VkExtent2D kExtent{96, 96};
  pelagic::SkyState state;
  state.clouds.cover = 1;
  pelagic::Sky sky = createSky(state, 1e5);
  pelagic::SkyView seen = createView(sky, kExtent);
  const double dip = std::acos(1e5 / (1e5 + 3));
  pelagic::Camera camera = cameraAt(3);
  const float tangent = static_cast<float>(std::tan(1.5 * dip));
  camera.projection = glm::mat4(1 / tangent, 0, 0, 0, 0, -1 / tangent, 0, 0, 0, 0, 0, -1, 0, 0, 0.1f, 0);
  gpu().run([&](vk::CommandBuffer commands) {
    sky.record(commands, 0);
    seen.record(commands, camera);
  });
  const support::SkyMap map = read(seen.maps().clouds);
  for (int y = 0; y < map.height; ++y) {
    const double down = 2 * (y + 0.5) / map.height - 1;  // of the pixel's middle, in halves of the picture
    for (int x = 0; x < map.width; ++x) {
      const double through = map.alpha(x, y);
      const double elevation = -std::atan(down * std::tan(1.5 * dip));
      if (elevation > -dip) {
        EXPECT_LT(through, 0.1) << x << ' ' << y;
      } else if (elevation < -1.3 * dip) {
        EXPECT_EQ(through, 1) << x << ' ' << y;
      }
    }
  }
}

TEST_F(SkyPlanetTest, BadRadiiAreNamed) {
  for (const double radius : {0.0, 0.99e5, 1.01e8, std::nan("")}) {
    const auto sky = pelagic::Sky::create(device(), {}, radius);
    ASSERT_FALSE(sky) << radius;
    EXPECT_EQ(sky.error().code, pelagic::ErrorCode::invalidArgument);
    EXPECT_NE(sky.error().message.find("planetRadius is "), std::string::npos);
  }
}

}  // namespace
