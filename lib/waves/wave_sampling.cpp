#include <cmath>
#include <pelagic/wave_sampling.hpp>
#include <waves/warp.hpp>

namespace pelagic {

shader::WaveSampling waveSampling(const WaveMaps& maps, const glm::dvec2& origin) noexcept {
  shader::WaveSampling sampling{};
  const Warp warp(maps.layout, maps.warp);
  sampling.warp = warp.relativeTo(origin);
  const double halfTexel = 0.5 / maps.layout.size;
  for (std::uint32_t c = 0; c < maps.layout.count; ++c) {
    const double length = maps.layout.cascades[c].length;
    const glm::dvec2 turns = warp.patchPlace(origin) / length;
    const glm::dvec2 patch = glm::floor(turns);
    const glm::dvec2 offset = turns - patch + halfTexel;
    sampling.placement[c] = glm::vec4(glm::dvec4(1 / length, offset.x, offset.y, length));
    constexpr double kApart = shader::kPatchesApart;
    sampling.patches[c] = glm::vec4(glm::dvec4(patch - kApart * glm::floor(patch / kApart), 0, 0));
    sampling.slopeCovariance[c] = glm::vec4(glm::vec3(maps.slopeCovariance[c]), 0);
    for (int mip = 0; mip < 8; ++mip) {
      sampling.interpolationLoss[2 * c + static_cast<std::uint32_t>(mip) / 4][mip % 4] =
          static_cast<float>(maps.interpolationLoss[c][static_cast<std::size_t>(mip)]);
    }
  }
  // From wind axes to world axes.
  const double c = std::cos(maps.windDirection);
  const double s = std::sin(maps.windDirection);
  const auto& [up, cross] = maps.unresolved;
  sampling.unresolved = glm::vec4(glm::dvec4(up * c * c + cross * s * s, up * s * s + cross * c * c,
                                             (up - cross) * c * s, maps.elevationDeviation));
  const double perMetre = 1 / maps.gainSpacing;
  const glm::dvec2 gainPlace = (origin - maps.gainOrigin) * perMetre;
  sampling.gain = glm::vec4(glm::dvec4(perMetre, gainPlace, maps.foamDecline));
  sampling.cascades = maps.layout.count;
  sampling.size = maps.layout.size;
  sampling.choppiness = static_cast<float>(maps.choppiness);
  sampling.maxLod = static_cast<float>(maps.displacement.mips - 1);
  return sampling;
}

}  // namespace pelagic
