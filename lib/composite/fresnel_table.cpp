#include <algorithm>
#include <cmath>
#include <composite/fresnel_table.hpp>

#include "physics/fresnel.glsl"
#include "physics/ocean_brdf.glsl"

namespace pelagic {

double meanFresnel(double cosView, double deviation) {
  if (deviation <= 0) return physics::fresnelReflectance(static_cast<float>(cosView), physics::kWaterIndex);
  const double sinView = std::sqrt(std::max(0.0, 1 - cosView * cosView));
  // Only slopes below cot(theta) face the viewer; along the view that edge bounds the integration. Weights are those of
  // seenSlopes() in physics/ocean_brdf.glsl.
  constexpr int kAlong = 96;
  constexpr int kAcross = 12;
  constexpr double kReach = 4.5;  // standard deviations
  const double last = sinView > 0 ? std::min(kReach, cosView / (sinView * deviation)) : kReach;
  const double step = (last + kReach) / kAlong;
  const double tau = std::max(sinView * deviation, 1e-6);
  const double margin = static_cast<double>(physics::kSightMargin);
  double sum = 0;
  double weight = 0;
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
      const double c = facing / std::sqrt(1 + along * along + across * across);
      sum += w * physics::fresnelReflectance(static_cast<float>(std::min(c, 1.0)), physics::kWaterIndex);
      weight += w;
    }
  }
  return sum / weight;
}

std::vector<float> fresnelTable() {
  std::vector<float> table;
  table.reserve(physics::kFresnelTableWidth * physics::kFresnelTableHeight);
  for (int j = 0; j < physics::kFresnelTableHeight; ++j) {
    const double y = static_cast<double>(j) / (physics::kFresnelTableHeight - 1);
    for (int i = 0; i < physics::kFresnelTableWidth; ++i) {
      const double x = static_cast<double>(i) / (physics::kFresnelTableWidth - 1);
      table.push_back(static_cast<float>(meanFresnel(x * x, physics::kFresnelMaxDeviation * y * y)));
    }
  }
  return table;
}

}  // namespace pelagic
