#include <algorithm>
#include <cmath>
#include <composite/fresnel_table.hpp>
#include <glm/gtc/packing.hpp>

#include "physics/fresnel.glsl"
#include "physics/ocean_brdf.glsl"

namespace pelagic {

ReflectingFacets reflectingFacets(double cosView, double deviation) {
  const auto fresnel = [](double cosIncidence) {
    return static_cast<double>(
        physics::fresnelReflectance(static_cast<float>(std::min(cosIncidence, 1.0)), physics::kWaterIndex));
  };
  if (deviation <= 0) return {fresnel(cosView), 0, 1};
  const double sinView = std::sqrt(std::max(0.0, 1 - cosView * cosView));
  // Only slopes below cot(theta) face the viewer; along the view that edge bounds the integration.
  constexpr int kAlong = 96;
  constexpr int kAcross = 12;
  constexpr double kReach = 4.5;  // standard deviations
  const double last = sinView > 0 ? std::min(kReach, cosView / (sinView * deviation)) : kReach;
  const double step = (last + kReach) / kAlong;
  const double tau = std::max(sinView * deviation, 1e-6);
  const double margin = static_cast<double>(physics::kSightMargin);
  double weight = 0, sum = 0, first = 0, second = 0;
  for (int i = 0; i < kAlong; ++i) {
    const double z = -kReach + (i + 0.5) * step;
    const double along = z * deviation;
    const double facing = cosView - sinView * along;
    const double hidden = std::exp(-2 * (facing / tau + margin) * (cosView / tau + margin));
    const double seen = facing * (1 - hidden) * std::exp(-0.5 * z * z);
    for (int j = 0; j < kAcross; ++j) {
      const double y = (j + 0.5) * kReach / kAcross;
      const double across = y * deviation;
      const double w = seen * std::exp(-0.5 * y * y);
      const double mirrored = w * fresnel(facing / std::sqrt(1 + along * along + across * across));
      weight += w;
      sum += mirrored;
      first -= mirrored * z;
      second += mirrored * z * z;
    }
  }
  return {sum / weight, first / sum, second / sum - first / sum * (first / sum)};
}

std::vector<glm::u16vec4> fresnelTable() {
  std::vector<glm::u16vec4> table;
  table.reserve(physics::kFresnelTableWidth * physics::kFresnelTableHeight);
  for (int j = 0; j < physics::kFresnelTableHeight; ++j) {
    const double y = static_cast<double>(j) / (physics::kFresnelTableHeight - 1);
    for (int i = 0; i < physics::kFresnelTableWidth; ++i) {
      const double x = static_cast<double>(i) / (physics::kFresnelTableWidth - 1);
      const ReflectingFacets facets = reflectingFacets(x * x, physics::kFresnelMaxDeviation * y * y);
      table.push_back(glm::packHalf(glm::vec4(glm::dvec4(facets.reflectance, facets.facing, facets.variance, 0))));
    }
  }
  return table;
}

}  // namespace pelagic
