#include <algorithm>
#include <cmath>
#include <gpu/field.hpp>
#include <limits>
#include <numbers>
#include <pelagic/sky.hpp>

namespace pelagic {

Result<void> validate(const SkyState& state) {
  // A float pi/2 is a little above the real one.
  constexpr double kZenith = std::numbers::pi / 2 + 1e-6;
  constexpr double kAny = std::numeric_limits<double>::max();
  PELAGIC_CHECK(
      gpu::check("SkyState::", {{"sunElevation", state.sunElevation, -kZenith, kZenith, "-pi/2 to pi/2"},
                                {"sunAzimuth", state.sunAzimuth, -kAny, kAny, "finite"},
                                {"overcast", state.overcast, 0, 1, "0 to 1"},
                                {"haze", state.haze, 0, 20, "0 to 20"},
                                {"hazeHeight", state.hazeHeight, 200, 5000, "200 to 5000 m"},
                                {"moonElevation", state.moonElevation, -kZenith, kZenith, "-pi/2 to pi/2"},
                                {"moonAzimuth", state.moonAzimuth, -kAny, kAny, "finite"},
                                {"moonIlluminated", state.moonIlluminated, 0, 1, "0 to 1"},
                                {"clouds.cover", state.clouds.cover, 0, 1, "0 to 1"},
                                {"clouds.base", state.clouds.base, 100, 8000, "100 to 8000 m"},
                                {"clouds.thickness", state.clouds.thickness, 50, 4000, "50 to 4000 m"},
                                {"clouds.velocity.x", state.clouds.velocity.x, -100, 100, "-100 to 100 m/s"},
                                {"clouds.velocity.y", state.clouds.velocity.y, -100, 100, "-100 to 100 m/s"}}));
  const glm::dmat3 difference = glm::transpose(state.starsToWorld) * state.starsToWorld - glm::dmat3(1);
  for (int column = 0; column < 3; ++column) {
    // Written so that NaN fails.
    if (!(glm::length(difference[column]) < 1e-6)) {
      return gpu::reject("SkyState::starsToWorld is not orthonormal in column " + std::to_string(column));
    }
  }
  if (glm::determinant(state.starsToWorld) < 0) {
    return gpu::reject("SkyState::starsToWorld has the determinant -1, it must be a rotation");
  }
  return {};
}

double twilightGain(double sunElevation) noexcept {
  const double depression = -sunElevation * 180 / std::numbers::pi;
  return std::exp2(std::clamp(1.45 * (depression - 2), 0.0, 20.0));
}

}  // namespace pelagic
