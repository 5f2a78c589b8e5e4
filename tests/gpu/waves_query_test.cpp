/// The CPU's sea against the maps of the GPU.
#include <cmath>
#include <pelagic/query.hpp>
#include <random>
#include <waves/warp.hpp>

#include "waves_support.hpp"

namespace {

using support::Fields;

class WaveQueryTest : public support::WavesTest {};

/// Height and horizontal displacement, summed over cascades, linear between the maps' texels.
glm::dvec3 lookUp(const std::vector<Fields>& maps, const pelagic::WaveLayout& layout, const glm::dvec2& p) {
  glm::dvec3 sum(0);
  const auto n = static_cast<std::int64_t>(layout.size);
  for (std::size_t c = 0; c < maps.size(); ++c) {
    const glm::dvec2 at = p * (static_cast<double>(n) / layout.cascades[c].length);
    const glm::dvec2 base = glm::floor(at);
    const glm::dvec2 f = at - base;
    const auto texel = [&](std::int64_t x, std::int64_t z) {
      const auto i = static_cast<std::size_t>(((z % n + n) % n) * n + (x % n + n) % n);
      return glm::dvec3(maps[c][1][i], maps[c][0][i], maps[c][2][i]);
    };
    const auto x = static_cast<std::int64_t>(base.x);
    const auto z = static_cast<std::int64_t>(base.y);
    sum +=
        glm::mix(glm::mix(texel(x, z), texel(x + 1, z), f.x), glm::mix(texel(x, z + 1), texel(x + 1, z + 1), f.x), f.y);
  }
  return sum;
}

TEST_F(WaveQueryTest, AgreesWithTheMapsInFiveSeas) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-5e3, 5e3);
  for (const pelagic::SeaState& sea : support::fiveSeas()) {
    pelagic::WavesInfo info;
    info.sea = sea;
    info.layout = *pelagic::waveLayout(sea, 3, 128);
    info.precision = pelagic::MapPrecision::single;
    pelagic::Waves waves = create(info);
    pelagic::SeaQuery query = *pelagic::SeaQuery::create(info);
    const double time = 86400 * 30 + 0.3;
    record(waves, time);
    query.setTime(time);
    std::vector<Fields> maps;
    for (std::uint32_t c = 0; c < info.layout.count; ++c) maps.push_back(read(waves.maps(), c));
    const double height = waves.report().gridHeight;
    const pelagic::Warp warp(info.layout, info.warp);
    double worst = 0;
    int missed = 0;
    constexpr int kPoints = 20000;
    for (int i = 0; i < kPoints; ++i) {
      const double x = place(random);
      const glm::dvec2 point(x, place(random));
      const pelagic::SurfacePoint at = query.at(point);
      const glm::vec2 shift = warp.at(point).shiftAt(glm::vec2(at.undisplaced - point));
      const glm::dvec3 d = lookUp(maps, info.layout, at.undisplaced + glm::dvec2(shift));
      worst = std::max(worst, std::abs(d.y - at.position.y));
      missed += glm::length(at.undisplaced + glm::dvec2(d.x, d.z) - point) > 1e-3 * height;
    }
    EXPECT_LT(worst, 1e-4 * height) << "wind " << sea.windSpeed;
    // Only where the surface folds, which is where it breaks, is there no single point over a place.
    EXPECT_LE(missed, kPoints / 1000) << "wind " << sea.windSpeed;
    RecordProperty("missed_" + std::to_string(static_cast<int>(sea.windSpeed)), missed);
  }
}

}  // namespace
