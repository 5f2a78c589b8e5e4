/// The sky of planets that are smaller or larger than the Earth.
#include <cmath>
#include <cstring>
#include <numbers>

#include "pelagic/shader/sky_light.h"
#include "support/gpu_test.hpp"

#include <pelagic/sky.hpp>

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

class SkyPlanetTest : public support::GpuTest {
 protected:
  pelagic::Sky create(const pelagic::SkyState& state, double planetRadius) {
    auto sky = pelagic::Sky::create(device(), state, planetRadius);
    if (!sky) throw std::runtime_error(sky.error().message);
    return std::move(*sky);
  }
  pelagic::SkyView view(const pelagic::Sky& sky, VkExtent2D extent) {
    auto view = pelagic::SkyView::create(sky, extent);
    if (!view) throw std::runtime_error(view.error().message);
    return std::move(*view);
  }
};

TEST_F(SkyPlanetTest, SunlightComesThroughTheAirOfThatPlanet) {
  for (const double radius : {1e5, 1737e3, 1e8}) {
    for (const double elevation : {0.03, 0.2, 0.8}) {
      pelagic::Sky sky = create({elevation, 0, 0, 1, {}}, radius);
      gpu().run([&](vk::CommandBuffer commands) { sky.record(commands, 0); });
      pelagic::shader::SkyLight light;
      const auto bytes = common::readBuffer(gpu(), sky.maps().light, sky.maps().lightSize);
      std::memcpy(&light, bytes.data(), sizeof(light));
      const Air air{radius, 1};
      const double mu = std::sin(elevation);
      const dvec3 expected = glm::exp(-air.opticalDepth(0, mu, air.distanceToTop(0, mu), 20000));
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(light.sunIrradiance[c], expected[c], 0.01 * expected[c] + 1e-4) << radius << ' ' << elevation;
      }
    }
  }
}

/// Light scattered more often adds a tenth to three.
TEST_F(SkyPlanetTest, RowsAreCountedFromItsHorizon) {
  const double sun = kPi / 3;
  for (const double radius : {1e5, 1737e3, 1e8}) {
    const Air air{radius, 0};
    pelagic::Sky sky = create({sun, 0, 0, 0, {}}, radius);
    pelagic::SkyView seen = view(sky, {16, 16});
    for (const double altitude : {0.0, 9000.0}) {
      pelagic::Camera camera;
      camera.position = {0, altitude, 0};
      gpu().run([&](vk::CommandBuffer commands) {
        sky.record(commands, 0);
        seen.record(commands, camera);
      });
      const pelagic::MapView map = seen.maps().radiance;
      const std::vector<float> texels = common::readFloats(gpu(), map);
      const double edge = -std::acos(radius / (radius + altitude));
      for (const std::uint32_t row : {1u, 8u, 60u, 126u}) {
        const double s = (row + 0.5) / (0.5 * map.extent.height), elevation = edge + (kPi / 2 - edge) * s * s;
        const std::uint32_t y = map.extent.height / 2 + row, x = map.extent.width / 4;
        const float* texel = &texels[4 * (std::size_t{y} * map.extent.width + x)];
        const double ratio = static_cast<double>(texel[0]) / air.scatteredOnce(altitude, elevation, sun).r;
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
  pelagic::Sky sky = create(state, 1e5);
  pelagic::SkyView seen = view(sky, kExtent);
  const double dip = std::acos(1e5 / (1e5 + 3));
  pelagic::Camera camera;
  camera.position = {0, 3, 0};
  const float tangent = static_cast<float>(std::tan(1.5 * dip));
  camera.projection = glm::mat4(1 / tangent, 0, 0, 0, 0, -1 / tangent, 0, 0, 0, 0, 0, -1, 0, 0, 0.1f, 0);
  gpu().run([&](vk::CommandBuffer commands) {
    sky.record(commands, 0);
    seen.record(commands, camera);
  });
  const pelagic::MapView map = seen.maps().clouds;
  const std::vector<float> texels = common::readFloats(gpu(), map);
  for (std::uint32_t y = 0; y < map.extent.height; ++y) {
    const double down = 2 * (3 * y + 1.5) / kExtent.height - 1;  // of the pixel's middle, in halves of the picture
    for (std::uint32_t x = 0; x < map.extent.width; ++x) {
      const double through = static_cast<double>(texels[4 * (std::size_t{y} * map.extent.width + x) + 3]);
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
