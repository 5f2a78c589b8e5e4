#include <cmath>
#include <numbers>

#include "sky_fixture.hpp"

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double radians(double degrees) { return degrees * kPi / 180; }

using Map = support::SkyMap;

class SkyViewTest : public support::SkyFixture {
 protected:
  struct Pair {
    pelagic::Sky sky;
    pelagic::SkyView view;
  };
  Pair create(const pelagic::SkyState& state) {
    pelagic::Sky sky = createSky(state);
    pelagic::SkyView view = createView(sky);
    return {std::move(sky), std::move(view)};
  }
  Map draw(Pair& pair, double altitude) {
    gpu().run([&](vk::CommandBuffer commands) {
      pair.sky.record(commands, 0);
      pair.view.record(commands, cameraAt(altitude));
    });
    return read(pair.view.maps().radiance);
  }
};

TEST_F(SkyViewTest, FromSeaLevelTheSkyIsTheSkys) {
  for (const double overcast : {0.0, 0.6}) {
    Pair pair = create({0.3, 1.0, overcast, 2, {}});
    const Map view = draw(pair, 0), sky = read(pair.sky.maps().radiance);
    for (int y = sky.height / 2; y < sky.height; y += 3) {
      for (int x = 0; x < sky.width; x += 7) {
        EXPECT_LT(glm::length(view.at(x, y) - sky.at(x, y)), 2e-3 * glm::length(sky.at(x, y))) << x << ' ' << y;
      }
    }
  }
}

/// Molecules alone over a flat Earth: with the optical depth t from the top, of which t0 lie over the sea and th over
/// the eye, the sun's light scattered once into a path down to the sea is P e^(-th/ms) (1 - e^(-(t0 - th)(1/ms +
/// 1/mv))) / (1 + mv/ms), and the path takes 1 - e^(-(t0 - th)/mv) of what comes from the sea. Light scattered more
/// often adds a tenth or two.
TEST_F(SkyViewTest, AirBelowTheEyeIsScatteringOnceAndALittleMore) {
  const double sun = radians(60), ms = std::sin(sun);
  Pair pair = create({sun, 0, 0, 0, {}});
  for (const double altitude : {0.0, 100.0, 3000.0, 9000.0}) {
    const Map map = draw(pair, altitude);
    const double edge = -std::acos(6371e3 / (6371e3 + altitude));
    for (const int row : {20, 60}) {
      const double s = 1 - (row + 0.5) / 128, elevation = edge - (kPi / 2 + edge) * s * s;
      const double mv = std::sin(-elevation);
      const int across = map.width / 4;  // at a right angle to the sun
      const double phase = 3 / (16 * kPi) * (1 + std::pow(mv * ms, 2));
      const double scattering = 7.10e-6 * 8000, th = scattering * std::exp(-std::max(altitude, 1.0) / 8000);
      const double ozone = std::exp(-2.58e-6 * 15000 / ms);
      const double light =
          ozone * phase * std::exp(-th / ms) * (1 - std::exp(-(scattering - th) * (1 / ms + 1 / mv))) / (1 + mv / ms);
      const double single = light / (1 - std::exp(-(scattering - th) / mv));
      const double ratio = map.at(across, row).r / single;
      EXPECT_GT(ratio, 1.03) << altitude << " m, row " << row;
      EXPECT_LT(ratio, 1.3) << altitude << " m, row " << row;
    }
  }
}

TEST_F(SkyViewTest, TheZenithDarkensWithAltitude) {
  Pair pair = create({radians(40), 0, 0, 1, {}});
  const glm::dvec3 low = draw(pair, 3).at(100, 255), high = draw(pair, 10e3).at(100, 255);
  EXPECT_NEAR(high.g / low.g, std::exp(-10.0 / 8), 0.15);
  // But where the eye looks through all of the air along the sea it is bright.
  EXPECT_GT(draw(pair, 10e3).at(100, 129).g, 3 * high.g);
}

TEST_F(SkyViewTest, UnchangedRecordsNothing) {
  Pair pair = create({});
  auto timings = pelagic::Timings::create(device());
  ASSERT_TRUE(timings);
  const auto passes = [&](double altitude) {
    gpu().run([&](vk::CommandBuffer commands) {
      timings->reset(commands);
      pair.sky.record(commands, 0);
      pair.view.record(commands, cameraAt(altitude), &*timings);
    });
    return timings->read()->size();
  };
  EXPECT_EQ(passes(3), 2u);
  EXPECT_EQ(passes(3.2), 0u);
  EXPECT_EQ(passes(4), 1u);
  ASSERT_TRUE(pair.sky.setState({0.2, 0, 0, 1, {}}));
  EXPECT_EQ(passes(4), 2u);
  EXPECT_EQ(passes(-20), 1u);
  EXPECT_EQ(passes(-30), 0u) << "below the sea the sky is that of its level";
}

}  // namespace
