#include <gtest/gtest.h>

#include <cmath>
#include <composite/fresnel_table.hpp>
#include <glm/gtc/packing.hpp>

#include "physics/fresnel.glsl"

namespace {

using namespace pelagic;
constexpr double kIndex = 1.34;

/// The textbook's two polarisations, from Snell's law.
double reflectance(double cosIncidence, double index) {
  const double sinRefracted = std::sqrt(1 - cosIncidence * cosIncidence) / index;
  const double cosRefracted = std::sqrt(1 - sinRefracted * sinRefracted);
  const double s = (cosIncidence - index * cosRefracted) / (cosIncidence + index * cosRefracted);
  const double p = (index * cosIncidence - cosRefracted) / (index * cosIncidence + cosRefracted);
  return 0.5 * (s * s + p * p);
}

/// Over the slopes seen by a midpoint rule on a fixed square, in double precision: mean reflectance, and mean and
/// variance of the facing counted by it, from the mean facet's in deviations.
glm::dvec3 meanReflection(double cosView, double along, double across) {
  const double sinView = std::sqrt(1 - cosView * cosView);
  const double tau = std::max(1e-9, sinView * along);
  constexpr int kSteps = 600;
  double sum = 0, first = 0, second = 0;
  double weight = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double x = -6 + 12 * (i + 0.5) / kSteps;
    const double facing = cosView - sinView * along * x;
    if (facing <= 0) continue;
    for (int j = 0; j < kSteps / 4; ++j) {
      const double y = -6 + 48 * (j + 0.5) / kSteps;
      const double hidden = std::exp(-2 * (facing / tau + 0.2) * (cosView / tau + 0.2));
      const double w = facing * (1 - hidden) * std::exp(-0.5 * (x * x + y * y));
      const double slope2 = along * along * x * x + across * across * y * y;
      const double mirrored = w * reflectance(std::min(1.0, facing / std::sqrt(1 + slope2)), kIndex);
      sum += mirrored;
      first += mirrored * (facing - cosView) / tau;
      second += mirrored * std::pow((facing - cosView) / tau, 2);
      weight += w;
    }
  }
  first /= sum;
  return {sum / weight, first, second / sum - first * first};
}
double meanReflectance(double cosView, double along, double across) { return meanReflection(cosView, along, across).x; }

glm::vec4 tableAt(const std::vector<glm::u16vec4>& table, float cosView, float deviation) {
  const glm::vec2 place = physics::fresnelTablePlace(cosView, deviation);
  const int i = std::min(static_cast<int>(place.x), physics::kFresnelTableWidth - 2);
  const int j = std::min(static_cast<int>(place.y), physics::kFresnelTableHeight - 2);
  const glm::vec2 f = place - glm::vec2(i, j);
  const auto entry = [&](int k) {
    return glm::unpackHalf(table[static_cast<std::size_t>(j * physics::kFresnelTableWidth + i + k)]);
  };
  const glm::vec4 low = glm::mix(entry(0), entry(1), f.x);
  const glm::vec4 high = glm::mix(entry(physics::kFresnelTableWidth), entry(physics::kFresnelTableWidth + 1), f.x);
  return glm::mix(low, high, f.y);
}

TEST(Fresnel, ClosedForms) {
  const float n = physics::kWaterIndex;
  const double normal = std::pow((kIndex - 1) / (kIndex + 1), 2);
  EXPECT_NEAR(physics::fresnelReflectance(1, n), normal, 1e-6);
  EXPECT_NEAR(physics::fresnelReflectance(1, 1 / n), normal, 1e-6);
  EXPECT_NEAR(physics::fresnelReflectance(0, n), 1, 1e-6);
  // Brewster's angle, tan = n: only s-polarised light returns.
  const double brewster = std::cos(std::atan(kIndex));
  const double s = (kIndex * kIndex - 1) / (kIndex * kIndex + 1);
  EXPECT_NEAR(physics::fresnelReflectance(static_cast<float>(brewster), n), 0.5 * s * s, 1e-6);
  for (double c = 0.02; c < 1; c += 0.02) {
    EXPECT_NEAR(physics::fresnelReflectance(static_cast<float>(c), n), reflectance(c, kIndex), 2e-6) << c;
  }
}

TEST(Fresnel, TotalReflectionOutsideSnellsWindow) {
  const double edge = std::sqrt(1 - 1 / (kIndex * kIndex));  // cosine of the critical angle
  EXPECT_EQ(physics::fresnelReflectance(static_cast<float>(edge - 0.01), 1 / physics::kWaterIndex), 1);
  EXPECT_LT(physics::fresnelReflectance(static_cast<float>(edge + 0.01), 1 / physics::kWaterIndex), 0.6f);
  // A ray sees the same surface from both sides.
  for (double c = 0.05; c < 1; c += 0.05) {
    const double refracted = std::sqrt(1 - (1 - c * c) / (kIndex * kIndex));
    EXPECT_NEAR(physics::fresnelReflectance(static_cast<float>(c), physics::kWaterIndex),
                physics::fresnelReflectance(static_cast<float>(refracted), 1 / physics::kWaterIndex), 2e-5);
  }
}

TEST(Fresnel, TableAgreesWithQuadrature) {
  const auto table = fresnelTable();
  for (const double deviation : {0.01, 0.03, 0.06, 0.1, 0.16, 0.25, 0.4}) {
    for (const double cosView : {0.0, 0.005, 0.03, 0.1, 0.22, 0.4, 0.6, 0.85, 1.0}) {
      const glm::dvec3 expected = meanReflection(cosView, deviation, deviation);
      const ReflectingFacets facets = reflectingFacets(cosView, deviation);
      EXPECT_NEAR(facets.reflectance, expected.x, 5e-4) << cosView << ' ' << deviation;
      const glm::vec4 entry = tableAt(table, static_cast<float>(cosView), static_cast<float>(deviation));
      EXPECT_NEAR(entry.x, expected.x, 0.006) << cosView << ' ' << deviation;
      if (cosView == 1) continue;  // all facets face alike
      EXPECT_NEAR(facets.facing, expected.y, 2e-3) << cosView << ' ' << deviation;
      EXPECT_NEAR(facets.variance, expected.z, 2e-3) << cosView << ' ' << deviation;
      EXPECT_NEAR(entry.y, expected.y, 0.03) << cosView << ' ' << deviation;
      EXPECT_NEAR(entry.z, expected.z, 0.03) << cosView << ' ' << deviation;
    }
  }
}

TEST(Fresnel, TheSlopesAcrossTheViewMatterLittle) {
  // The table takes the deviation along the view for both: a sea rougher or smoother across differs by this much.
  for (const double cosView : {0.03, 0.1, 0.3, 0.7}) {
    EXPECT_NEAR(meanReflectance(cosView, 0.15, 0.10), meanReflectance(cosView, 0.15, 0.15), 0.002);
    EXPECT_NEAR(meanReflectance(cosView, 0.15, 0.20), meanReflectance(cosView, 0.15, 0.15), 0.003);
  }
}

TEST(Fresnel, FitStaysWithinItsStatedError) {
  double worst = 0;
  for (const double deviation : {0.02, 0.06, 0.1, 0.16, 0.25}) {
    for (double c = 0; c <= 1; c += 0.05) {
      const double fit = physics::meanFresnelFit(static_cast<float>(c), static_cast<float>(deviation));
      worst = std::max(worst, std::abs(fit - reflectingFacets(c, deviation).reflectance));
    }
  }
  EXPECT_LT(worst, 0.16);
  EXPECT_GT(worst, 0.03);  // or the table would not be worth its place
}

}  // namespace
