#include <pelagic/sky.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include "physics/atmosphere.glsl"
#include "sky_fixture.hpp"

namespace {

namespace air = pelagic::shader;
using glm::dvec3;
constexpr double kPi = std::numbers::pi;
constexpr double radians(double degrees) { return degrees * kPi / 180; }

double luminance(const dvec3& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

using Map = support::SkyMap;

class SkyTest : public support::SkyFixture {
 protected:
  struct Picture {
    Map radiance, environment;
    air::SkyLight light;
  };
  static pelagic::SkyState stateOf(double elevationDegrees, double overcast = 0) {
    pelagic::SkyState state;
    state.sunElevation = radians(elevationDegrees);
    state.sunAzimuth = 2.0;
    state.overcast = overcast;
    return state;
  }
  Picture draw(pelagic::Sky& sky, const pelagic::SkyState& state) {
    if (const auto set = sky.setState(state); !set) throw std::runtime_error(set.error().message);
    gpu().run([&](vk::CommandBuffer commands) { sky.record(commands, 0); });
    return {read(sky.maps().radiance), read(sky.maps().environment), light(sky.maps())};
  }
};

/// Integral of L sin(e) over the upper half of the radiance map, by its definition in the public header.
dvec3 horizontalIrradiance(const Map& map) {
  dvec3 sum(0);
  for (int y = map.height / 2; y < map.height; ++y) {
    const auto sine = [&](double row) { return std::sin(kPi / 2 * std::pow(2 * row / map.height - 1, 2)); };
    const double weight = 0.5 * (std::pow(sine(y + 1), 2) - std::pow(sine(y), 2)) * 2 * kPi / map.width;
    for (int x = 0; x < map.width; ++x) sum += weight * map.at(x, y);
  }
  return sum;
}

/// Transmittance from sea level in double precision, densities and coefficients written out again.
dvec3 transmittance(double elevation, double haze, double hazeHeight) {
  constexpr double r = 6371e3, top = 100e3;
  const double mu = std::sin(elevation);
  const double end = -r * mu + std::sqrt(r * r * (mu * mu - 1) + (r + top) * (r + top));
  constexpr int kSteps = 100000;
  dvec3 depth(0);
  for (int i = 0; i < kSteps; ++i) {
    const double t = end * (i + 0.5) / kSteps;
    const double h = std::sqrt(r * r + 2 * r * mu * t + t * t) - r;
    depth += end / kSteps *
             (dvec3(7.10e-6, 1.38e-5, 3.31e-5) * std::exp(-h / 8000) +
              haze * dvec3(5.50e-5, 5.86e-5, 6.38e-5) * std::exp(-h / hazeHeight) +
              dvec3(2.58e-6, 1.71e-6, 0) * std::max(0.0, 1 - std::abs(h - 25e3) / 15e3));
  }
  return glm::exp(-depth);
}

TEST_F(SkyTest, SunlightIsWhatQuadratureLeavesOfIt) {
  auto sky = createSky({});
  for (const double degrees : {90.0, 40.0, 15.0, 5.0, 1.0}) {
    for (const auto& [haze, hazeHeight] : {std::pair(1.0, 1200.0), std::pair(4.0, 1200.0), std::pair(3.0, 300.0)}) {
      pelagic::SkyState state = stateOf(degrees);
      state.haze = haze;
      state.hazeHeight = hazeHeight;
      const auto light = draw(sky, state).light;
      const dvec3 expected = transmittance(state.sunElevation, haze, hazeHeight);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(light.sunIrradiance[c], expected[c], 0.01 * expected[c])
            << degrees << ' ' << haze << ' ' << hazeHeight << ' ' << c;
        EXPECT_NEAR(light.sunRadiance[c], expected[c] / (kPi * 0.004675 * 0.004675), 0.01 * light.sunRadiance[c]);
      }
      const dvec3 toSun(std::cos(state.sunElevation) * std::cos(2.0), std::sin(state.sunElevation),
                        std::cos(state.sunElevation) * std::sin(2.0));
      EXPECT_LT(glm::length(toSun - dvec3(light.sunDirection)), 1e-6);
    }
  }
}

TEST_F(SkyTest, SunlightFadesAndReddensAsTheDiscSets) {
  auto sky = createSky({});
  double before = 1;
  double redder = 0;
  for (const double degrees : {60.0, 20.0, 5.0, 1.0, 0.2, 0.0, -0.2, -0.26}) {
    const dvec3 sun(draw(sky, stateOf(degrees)).light.sunIrradiance);
    EXPECT_LT(luminance(sun), before) << degrees;
    EXPECT_GT(sun.r / sun.g, redder) << degrees;
    EXPECT_GT(luminance(sun), 0) << degrees;
    before = luminance(sun);
    redder = sun.r / sun.g;
  }
  EXPECT_EQ(draw(sky, stateOf(-0.3)).light.sunIrradiance.r, 0);
  EXPECT_EQ(draw(sky, stateOf(-0.3)).light.sunRadiance.r, 0);
}

TEST_F(SkyTest, SkyIrradianceIsTheIntegralOfTheMap) {
  auto sky = createSky({});
  for (const double degrees : {70.0, 20.0, 1.0, -5.0, -12.0}) {
    for (const double overcast : {0.0, 0.4, 1.0}) {
      const Picture picture = draw(sky, stateOf(degrees, overcast));
      const dvec3 integral = horizontalIrradiance(picture.radiance);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(picture.light.skyIrradiance[c], integral[c], 0.005 * integral[c]) << degrees << ' ' << overcast;
      }
    }
  }
}

TEST_F(SkyTest, NoMoreLightComesDownThanEntersTheAir) {
  auto sky = createSky({});
  for (const double degrees : {90.0, 45.0, 20.0, 8.0, 3.0}) {
    for (const double haze : {0.0, 1.0, 10.0}) {
      pelagic::SkyState state = stateOf(degrees);
      state.haze = haze;
      const auto light = draw(sky, state).light;
      const double sine = std::sin(state.sunElevation);
      for (int c = 0; c < 3; ++c) {
        const double global = light.skyIrradiance[c] + light.sunIrradiance[c] * sine;
        EXPECT_LT(global, sine) << degrees << ' ' << haze << ' ' << c;
        EXPECT_GT(global, (degrees < 10 ? 0.15 : 0.4) * sine) << degrees << ' ' << haze << ' ' << c;
      }
    }
  }
}

/// Single scattering by molecules alone has a closed form: L = P(mu) (1 - T^(1 + m_v/m_s)) ... for a flat Earth, good
/// to the curvature's few per mille at the zenith.
TEST_F(SkyTest, ZenithOfPureAirIsSingleScatteringAndALittleMore) {
  pelagic::SkyState state = stateOf(60);
  state.haze = 0;
  auto sky = createSky(state);
  const Picture picture = draw(sky, state);
  const dvec3 zenith = picture.radiance.toward(0, radians(89.5));
  const double phase = 3 / (16 * kPi) * (1 + 0.75);
  const double depth = 7.10e-6 * 8000, airMass = 1 / std::sin(radians(60));
  const double ozone = std::exp(-2.58e-6 * 15000 * airMass);  // above most of the molecules
  const double single = ozone * phase * (std::exp(-depth) - std::exp(-depth * airMass)) / (airMass - 1);
  EXPECT_GT(zenith.r, 1.03 * single);
  EXPECT_LT(zenith.r, 1.2 * single);
}

/// Share of a plane beam at mu0 that reaches the ground scattered, by following photons through a flat layer of
/// molecules of the optical depth `depth` over a diffuse ground: every order of scattering, the exact phase function.
double scatteredShare(double depth, double mu0, double albedo, int photons) {
  std::mt19937 random(7);
  const auto uniform = [&] { return (static_cast<double>(random()) + 0.5) / 4294967296.0; };
  double landed = 0;
  for (int i = 0; i < photons; ++i) {
    double at = 0, mu = mu0;  // optical depth from the top; mu > 0 is downward
    bool scattered = false;
    for (double weight = 1; weight > 0;) {
      at += -std::log(uniform()) * mu;
      if (at < 0) break;
      if (at > depth) {
        if (scattered) landed += weight;
        weight *= albedo;
        if (weight < 1e-6) break;
        at = depth;
        mu = -std::sqrt(uniform());
      } else {
        double turn = 0;
        do turn = 2 * uniform() - 1;
        while (2 * uniform() > 1 + turn * turn);
        const double around = std::cos(2 * kPi * uniform());
        mu = mu * turn + std::sqrt((1 - mu * mu) * (1 - turn * turn)) * around;
      }
      scattered = true;
    }
  }
  return landed / photons;
}

/// Molecules do not absorb blue light, so that this is a closed benchmark of all orders of scattering.
TEST_F(SkyTest, BlueLightOfPureAirIsWhatPhotonsFind) {
  auto sky = createSky({});
  for (const double degrees : {80.0, 50.0, 30.0}) {
    pelagic::SkyState state = stateOf(degrees);
    state.haze = 0;
    const double sine = std::sin(state.sunElevation);
    const double expected = sine * scatteredShare(3.31e-5 * 8000, sine, 0.06, 400000);
    EXPECT_NEAR(draw(sky, state).light.skyIrradiance.b, expected, 0.03 * expected) << degrees;
  }
}

TEST_F(SkyTest, ColoursOfDayAndDusk) {
  auto sky = createSky({});
  const Map noon = draw(sky, stateOf(60)).radiance;
  const dvec3 high = noon.toward(2.0 + kPi, radians(60)), low = noon.toward(2.0 + kPi, radians(2));
  EXPECT_GT(high.b, 1.7 * high.r);
  EXPECT_GT(luminance(low), 1.5 * luminance(high));  // the horizon is brighter
  EXPECT_LT(low.b / low.r, 0.8 * high.b / high.r);   // and whiter
  const Map sunset = draw(sky, stateOf(1)).radiance;
  const dvec3 glow = sunset.toward(2.0, radians(1)), away = sunset.toward(2.0 + kPi, radians(60));
  EXPECT_GT(glow.r, 1.5 * glow.g);
  EXPECT_GT(glow.g, 1.5 * glow.b);
  EXPECT_GT(away.b, 1.3 * away.r);
  // The sun's side is the brighter one, at the azimuth that was asked for.
  EXPECT_GT(luminance(glow), 5 * luminance(sunset.toward(2.0 + kPi, radians(1))));
  EXPECT_GT(luminance(glow), 2 * luminance(sunset.toward(-2.0, radians(1))));
}

TEST_F(SkyTest, TwilightFadesAsMeasured) {
  // Illuminance of clear twilight in lux (Explanatory Supplement to the Astronomical Almanac), within a factor of 3.
  auto sky = createSky({});
  const std::pair<double, double> measured[] = {{0, 700}, {-3, 80}, {-6, 3.5}, {-12, 0.008}};
  for (const auto& [degrees, lux] : measured) {
    const auto light = draw(sky, stateOf(degrees)).light;
    EXPECT_FLOAT_EQ(light.skyIrradiance.w, static_cast<float>(pelagic::twilightGain(radians(degrees))));
    const double here = luminance(dvec3(light.skyIrradiance)) / light.skyIrradiance.w * 1.28e5;
    EXPECT_LT(here, 3 * lux) << degrees;
    EXPECT_GT(here, lux / 3) << degrees;
  }
}

TEST_F(SkyTest, OvercastFollowsTheStandard) {
  auto sky = createSky({});
  const auto clear = draw(sky, stateOf(35)).light;
  const Picture picture = draw(sky, stateOf(35, 1));
  const Map& map = picture.radiance;
  const dvec3 zenith(picture.light.cloudZenith);
  for (const int y : {130, 160, 200, 255}) {
    const double elevation = kPi / 2 * std::pow(2 * (y + 0.5) / 256 - 1, 2);
    for (const int x : {0, 100, 300, 511}) {
      const dvec3 expected = zenith * (1 + 2 * std::sin(elevation)) / 3.0;
      EXPECT_LT(glm::length(map.at(x, y) - expected), 2e-3 * glm::length(expected)) << x << ' ' << y;
    }
  }
  EXPECT_EQ(glm::length(glm::vec3(picture.light.sunIrradiance)), 0);
  const double global = luminance(dvec3(clear.skyIrradiance) + dvec3(clear.sunIrradiance) * std::sin(radians(35)));
  EXPECT_NEAR(luminance(dvec3(picture.light.skyIrradiance)), 0.3 * global, 0.003 * global);
  EXPECT_LT(zenith.b / zenith.r, 1.25);  // neutral, a little bluish
  EXPECT_GT(zenith.b / zenith.r, 1.0);
}

TEST_F(SkyTest, CloudsMixLinearly) {
  auto sky = createSky({});
  const Picture clear = draw(sky, stateOf(35)), full = draw(sky, stateOf(35, 1)), part = draw(sky, stateOf(35, 0.25));
  for (int y = 128; y < 256; y += 9) {
    for (int x = 0; x < 512; x += 31) {
      const dvec3 expected = 0.75 * clear.radiance.at(x, y) + 0.25 * full.radiance.at(x, y);
      EXPECT_LT(glm::length(part.radiance.at(x, y) - expected), 3e-3 * glm::length(expected));
    }
  }
  EXPECT_NEAR(part.light.sunIrradiance.g, 0.75 * clear.light.sunIrradiance.g, 1e-5);
}

TEST_F(SkyTest, BelowTheHorizonTheMapHoldsTheHorizon) {
  auto sky = createSky({});
  const Map map = draw(sky, stateOf(3)).radiance;
  for (int x = 0; x < map.width; x += 17) {
    for (const int y : {0, 60, 127}) {
      EXPECT_LT(glm::length(map.at(x, y) - map.at(x, 128)), 2e-3 * glm::length(map.at(x, 128))) << x << ' ' << y;
    }
  }
}

TEST_F(SkyTest, EnvironmentIsTheRadianceMapAtTheSameDirections) {
  auto sky = createSky({});
  const Picture picture = draw(sky, stateOf(12));
  const Map& environment = picture.environment;
  for (int y = 3; y < environment.height; y += 16) {
    for (int x = 5; x < environment.width; x += 16) {
      const glm::dvec2 q = (2.0 * glm::dvec2(x + 0.5, y + 0.5) / double(environment.width) - 1.0) / 0.8;
      const double r2 = glm::dot(q, q);
      if (std::abs(std::sqrt(r2) - 1) < 0.03) continue;
      EXPECT_EQ(environment.alpha(x, y), r2 < 1 ? 1 : 0);
      if (r2 >= 1) {
        EXPECT_EQ(glm::length(environment.at(x, y)), 0);
        continue;
      }
      // The direction whose (x, z)/(1 + y) is q.
      const dvec3 r(2 * q.x / (1 + r2), (1 - r2) / (1 + r2), 2 * q.y / (1 + r2));
      const dvec3 expected = picture.radiance.toward(std::atan2(r.z, r.x), std::asin(r.y));
      EXPECT_LT(glm::length(environment.at(x, y) - expected), 0.01 * glm::length(expected)) << x << ' ' << y;
    }
  }
}

TEST_F(SkyTest, MipsKeepTheSum) {
  auto sky = createSky({});
  draw(sky, stateOf(12));
  const auto meanOf = [&](std::uint32_t mip) {
    const Map map = read(sky.maps().environment, mip);
    glm::dvec4 sum(0);
    for (int y = 0; y < map.height; ++y) {
      for (int x = 0; x < map.width; ++x) sum += glm::dvec4(map.at(x, y), map.alpha(x, y));
    }
    return sum / double(map.width * map.height);
  };
  const glm::dvec4 first = meanOf(0);
  EXPECT_NEAR(first.w, kPi * 0.4 * 0.4, 1e-3);  // the disc's share of the square
  ASSERT_EQ(sky.maps().environment.mips, 9u);
  for (std::uint32_t mip = 1; mip < 9; ++mip) {
    EXPECT_LT(glm::length(meanOf(mip) - first), 3e-3 * glm::length(first)) << mip;
  }
}

TEST_F(SkyTest, MipsAreBinomial) {
  auto sky = createSky({});
  const Map fine = draw(sky, stateOf(12)).environment;
  const Map coarse = read(sky.maps().environment, 1);
  constexpr double kWeights[] = {0.125, 0.375, 0.375, 0.125};
  for (int y = 13; y < 120; y += 7) {
    for (int x = 12; x < 120; x += 5) {
      glm::dvec4 expected(0);
      for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) {
          const int u = 2 * x + i - 1, v = 2 * y + j - 1;
          expected += kWeights[i] * kWeights[j] * glm::dvec4(fine.at(u, v), fine.alpha(u, v));
        }
      }
      const glm::dvec4 value(coarse.at(x, y), coarse.alpha(x, y));
      EXPECT_LT(glm::length(value - expected), 5e-3 * glm::length(expected) + 1e-6) << x << ' ' << y;
    }
  }
}

TEST_F(SkyTest, AerialPerspectiveGetsTheExtinctionAtSeaLevel) {
  pelagic::SkyState state = stateOf(30);
  state.haze = 3;
  state.hazeHeight = 400;
  auto sky = createSky(state);
  const auto light = draw(sky, state).light;
  EXPECT_NEAR(light.rayleighExtinction.b, 3.31e-5, 1e-8);
  EXPECT_EQ(light.rayleighExtinction.w, 8000);
  EXPECT_NEAR(light.mieExtinction.g, 3 * 5.86e-5, 1e-8);
  EXPECT_EQ(light.mieExtinction.w, 400);
}

TEST_F(SkyTest, UnchangedStateRecordsNothing) {
  auto sky = createSky(stateOf(30));
  auto timings = pelagic::Timings::create(device());
  ASSERT_TRUE(timings);
  const auto passes = [&] {
    gpu().run([&](vk::CommandBuffer commands) {
      timings->reset(commands);
      sky.record(commands, 0, &*timings);
    });
    return timings->read()->size();
  };
  EXPECT_EQ(passes(), 3u);
  EXPECT_EQ(passes(), 0u);
  ASSERT_TRUE(sky.setState(stateOf(30)));
  EXPECT_EQ(passes(), 0u);
  ASSERT_TRUE(sky.setState(stateOf(31)));
  EXPECT_EQ(passes(), 2u);  // the air itself is as before
  pelagic::SkyState hazy = stateOf(31);
  hazy.haze = 2;
  ASSERT_TRUE(sky.setState(hazy));
  EXPECT_EQ(passes(), 3u);
  hazy.hazeHeight = 500;
  ASSERT_TRUE(sky.setState(hazy));
  EXPECT_EQ(passes(), 3u);
}

TEST_F(SkyTest, EachFieldIsRefusedByName) {
  auto sky = createSky({});
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  struct Case {
    const char* name;
    double pelagic::SkyState::*field;
    std::vector<double> wrong;
  };
  const Case cases[] = {{"sunElevation", &pelagic::SkyState::sunElevation, {nan, 1.6, -1.6, infinity}},
                        {"sunAzimuth", &pelagic::SkyState::sunAzimuth, {nan, infinity, -infinity}},
                        {"overcast", &pelagic::SkyState::overcast, {nan, -0.01, 1.01, infinity}},
                        {"haze", &pelagic::SkyState::haze, {nan, -0.01, 20.1, infinity}},
                        {"hazeHeight", &pelagic::SkyState::hazeHeight, {nan, 0, 199, 5001, infinity}}};
  for (const Case& test : cases) {
    for (const double value : test.wrong) {
      pelagic::SkyState state;
      state.*test.field = value;
      const auto result = sky.setState(state);
      ASSERT_FALSE(result) << test.name << ' ' << value;
      EXPECT_EQ(result.error().code, pelagic::ErrorCode::invalidArgument);
      EXPECT_NE(result.error().message.find(std::string("SkyState::") + test.name + " is "), std::string::npos);
      EXPECT_FALSE(pelagic::Sky::create(device(), state));
    }
  }
}

}  // namespace
