#include <bit>
#include <cmath>
#include <numbers>
#include <waves/warp.hpp>

namespace pelagic {
namespace {

struct Wave {
  double angle;       ///< Of the wave [degrees].
  double wavelength;  ///< In lengths of the longest patch.
  double phase;       ///< At the origin [turns]: a quarter either way, where the wave turns and has no slope.
};
/// Spread over all directions and two octaves, none a multiple of another; found by trying 300 such sets for the least
/// correlation that is left between places a patch apart.
constexpr Wave kTable[] = {{14, 3.21, 0.25},   {23, 6.12, 0.25},  {50, 4.09, -0.25}, {74, 7.42, -0.25},
                           {91, 11.47, -0.25}, {128, 9.53, 0.25}, {137, 4.63, 0.25}, {165, 5.73, -0.25}};

}  // namespace

Warp::Warp(const WaveLayout& layout, double gradient) noexcept {
  for (std::size_t i = 0; i < kWaves; ++i) {
    const double angle = kTable[i].angle * std::numbers::pi / 180;
    const double length = kTable[i].wavelength * layout.cascades[0].length;
    alongX_[i] = std::cos(angle) / length;
    alongZ_[i] = std::sin(angle) / length;
    // It displaces at 45 degrees to its direction, to either side in turn: stretch and shear alike in all directions.
    // The derivative of 8 t (1 - 2 |t|) has the mean square 64/3, so a component of the sum's has 8/4 (a/length)^2
    // 64/3.
    const double amplitude = gradient * length * std::sqrt(3.0 / 128);
    const double aside = angle + (i % 2 == 0 ? -0.25 : 0.25) * std::numbers::pi;
    const std::size_t group = i / 4;
    const auto lane = static_cast<int>(i % 4);
    still_.alongX[group][lane] = static_cast<float>(alongX_[i]);
    still_.alongZ[group][lane] = static_cast<float>(alongZ_[i]);
    still_.shiftX[group][lane] = static_cast<float>(amplitude * std::cos(aside));
    still_.shiftZ[group][lane] = static_cast<float>(amplitude * std::sin(aside));
    const double atOrigin = kTable[i].phase > 0 ? 1 : -1;  // 8 t (1 - 2 |t|) of a quarter
    origin_ += atOrigin * amplitude * glm::dvec2(std::cos(aside), std::sin(aside));
  }
}

Warp::Turns Warp::turnsAt(const glm::dvec2& place) const noexcept {
  // Added and taken away, it leaves the nearest whole number, without a call.
  constexpr double kRounder = 0x1.8p52;
  Turns turns;
  for (std::size_t i = 0; i < kWaves; ++i) {
    const double all = alongX_[i] * place.x + alongZ_[i] * place.y + kTable[i].phase;
    turns.of[i] = static_cast<float>(all - ((all + kRounder) - kRounder));
  }
  return turns;
}

shader::WaveWarp Warp::relativeTo(const glm::dvec2& origin) const noexcept {
  const Turns turns = turnsAt(origin);
  shader::WaveWarp warp = still_;
  for (std::size_t i = 0; i < kWaves; ++i) warp.phase[i / 4][static_cast<int>(i % 4)] = turns.of[i];
  return warp;
}

LocalWarp Warp::at(const glm::dvec2& place) const noexcept {
  const auto turns = std::bit_cast<std::array<Float4, 2>>(turnsAt(place));
  Float4 shiftX{}, shiftZ{}, xx{}, xz{}, zx{}, zz{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Float4 t = turns[i];
    const Float4 wave = t * (8.0f - 16.0f * absolute(t));
    const Float4 rate = 8.0f - 32.0f * absolute(t);
    const Float4 byX = rate * float4Of(still_.alongX[i]);
    const Float4 byZ = rate * float4Of(still_.alongZ[i]);
    const Float4 x = float4Of(still_.shiftX[i]);
    const Float4 z = float4Of(still_.shiftZ[i]);
    shiftX += wave * x;
    shiftZ += wave * z;
    xx += byX * x;
    xz += byX * z;
    zx += byZ * x;
    zz += byZ * z;
  }
  return {glm::vec2(sumOf(shiftX), sumOf(shiftZ)) - glm::vec2(origin_), {sumOf(xx), sumOf(xz), sumOf(zx), sumOf(zz)}};
}

}  // namespace pelagic
