#include <cmath>

#include "waves_support.hpp"

namespace {

class WaveFilterTest : public support::WavesTest {
 protected:
  /// Means over the map of (variance of the texels' mean dh/dx + the variance within the texels), the same of dh/dz,
  /// and their covariance.
  glm::dvec3 slopes(const pelagic::WaveMaps& maps, std::uint32_t cascade, std::uint32_t mip) {
    const auto gradient = common::readFloats(gpu(), maps.gradient, mip, cascade);
    const auto moments = common::readFloats(gpu(), maps.moments, mip, cascade);
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < gradient.size(); i += 4) {
      const glm::dvec2 g(gradient[i], gradient[i + 1]);
      sum += glm::dvec3(g.x * g.x, g.y * g.y, g.x * g.y) + glm::dvec3(moments[i], moments[i + 1], moments[i + 2]);
    }
    return sum / (static_cast<double>(gradient.size()) / 4);
  }
};

TEST_F(WaveFilterTest, ResolvedPlusResidualIsTheSameInEveryMip) {
  for (const std::uint32_t size : {64u, 256u}) {
    const auto info = support::wavesInfo(size, 2, 10);
    auto waves = create(info);
    record(waves, 33);
    const auto maps = waves.maps();
    for (std::uint32_t c = 0; c < 2; ++c) {
      const auto total = slopes(maps, c, 0);
      ASSERT_GT(total.x, 1e-4);
      for (std::uint32_t mip = 1; mip < maps.gradient.mips; ++mip) {
        const auto sum = slopes(maps, c, mip);
        EXPECT_NEAR(sum.x / total.x, 1, 1e-4) << "mip " << mip;
        EXPECT_NEAR(sum.y / total.y, 1, 1e-4) << "mip " << mip;
        EXPECT_NEAR(sum.z / total.x, total.z / total.x, 1e-4) << "mip " << mip;
      }
    }
  }
}

TEST_F(WaveFilterTest, MipsAreMeansOfTheFinest) {
  const auto info = support::wavesInfo(128, 2, 15);
  auto waves = create(info);
  record(waves, 33);
  const auto maps = waves.maps();
  struct Channels {
    const pelagic::MapView* map;
    std::size_t stride;
    std::vector<std::size_t> means;
  };
  const Channels all[] = {{&maps.displacement, 4, {0, 1, 2, 3}},
                          {&maps.gradient, 4, {0, 1, 2, 3}},
                          {&maps.moments, 4, {3}},
                          {&maps.foam, 1, {0}}};
  for (const auto& [map, stride, means] : all) {
    const auto finest = common::readFloats(gpu(), *map, 0, 1);
    for (std::uint32_t mip = 1; mip < map->mips; ++mip) {
      const auto coarse = common::readFloats(gpu(), *map, mip, 1);
      const std::size_t side = 128u >> mip;
      const std::size_t box = 1u << mip;
      for (std::size_t texel = 0; texel < side * side; texel += 1 + side / 2) {
        for (const std::size_t channel : means) {
          double sum = 0;
          for (std::size_t y = 0; y < box; ++y) {
            for (std::size_t x = 0; x < box; ++x) {
              const std::size_t at = (texel / side * box + y) * 128 + texel % side * box + x;
              sum += static_cast<double>(finest[at * stride + channel]);
            }
          }
          ASSERT_NEAR(coarse[texel * stride + channel], sum / static_cast<double>(box * box), 2e-6)
              << "mip " << mip << " channel " << channel;
        }
      }
    }
  }
}

TEST_F(WaveFilterTest, HalfMapsAreRoundedSingleMaps) {
  auto info = support::wavesInfo(128, 2, 12);
  auto single = create(info);
  info.precision = pelagic::MapPrecision::half;
  auto half = create(info);
  record(single, 71.5);
  record(half, 71.5);
  const auto exact = single.maps();
  const auto rounded = half.maps();
  EXPECT_EQ(rounded.displacement.format, VK_FORMAT_R16G16B16A16_SFLOAT);
  EXPECT_EQ(exact.foam.format, VK_FORMAT_R32_SFLOAT);
  struct Pair {
    const pelagic::MapView *a, *b;
    double smallest;  ///< Absolute error: a mean has that of its larger texels.
  };
  const Pair pairs[] = {{&exact.displacement, &rounded.displacement, 4e-3},
                        {&exact.gradient, &rounded.gradient, 1e-3},
                        {&exact.moments, &rounded.moments, 1e-4},
                        {&exact.foam, &rounded.foam, 1e-3}};
  for (const auto& [a, b, smallest] : pairs) {
    for (std::uint32_t mip = 0; mip < a->mips; ++mip) {
      const auto x = common::readFloats(gpu(), *a, mip, 0);
      const auto y = common::readFloats(gpu(), *b, mip, 0);
      ASSERT_EQ(x.size(), y.size());
      for (std::size_t i = 0; i < x.size(); ++i) {
        // The device may round to half either way, by a unit of the 11th bit; a mip is rounded after its source was.
        ASSERT_NEAR(x[i], y[i], smallest + std::abs(x[i]) * 3e-3) << "mip " << mip;
      }
    }
  }
}

}  // namespace
