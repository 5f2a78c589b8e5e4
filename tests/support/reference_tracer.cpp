#include "reference_tracer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "physics/fresnel.glsl"

namespace support {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr int kWaves = 400;
constexpr double kLongest = 4;   ///< Waves a side.
constexpr double kShortest = 8;  ///< [cells]
constexpr int kBounces = 6;

/// cos and sin of 2 pi mode i / size.
std::vector<glm::dvec2> turns(int mode, std::uint32_t size, double phase) {
  std::vector<glm::dvec2> result(size);
  for (std::uint32_t i = 0; i < size; ++i) {
    const double angle = kTwoPi * mode * i / size + phase;
    result[i] = {std::cos(angle), std::sin(angle)};
  }
  return result;
}

}  // namespace

FacetedSea::FacetedSea(std::uint32_t size, double along, double across, std::uint32_t seed, double longest)
    : size_(size), heights_(std::size_t{size} * size, 0.0) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  // Equal slopes each; directions by 1 + delta cos 2 theta, whose mean cos^2 is (1 + delta/2)/2.
  const double delta = 2 * (along - across) / (along + across);
  const double slope = std::sqrt(2 * (along + across) / kWaves);
  for (int wave = 0; wave < std::lround(longest * kWaves); ++wave) {
    const double k = kLongest * std::pow(size / (kShortest * kLongest), (wave + unit(random)) / kWaves);
    double theta = kTwoPi * unit(random);
    while (unit(random) * (1 + std::abs(delta)) > 1 + delta * std::cos(2 * theta)) theta = kTwoPi * unit(random);
    const int mx = static_cast<int>(std::lround(k * std::cos(theta)));
    const int mz = static_cast<int>(std::lround(k * std::sin(theta)));
    const double amplitude = slope * size / (kTwoPi * std::hypot(mx, mz));
    const auto x = turns(mx, size, kTwoPi * unit(random));
    const auto z = turns(mz, size, 0);
    for (std::uint32_t j = 0; j < size; ++j) {
      double* row = &heights_[std::size_t{j} * size];
      for (std::uint32_t i = 0; i < size; ++i) row[i] += amplitude * (x[i].x * z[j].x - x[i].y * z[j].y);
    }
  }
  top_ = *std::max_element(heights_.begin(), heights_.end());
}

glm::dvec3 FacetedSea::slopeCovariance() const {
  glm::dvec3 sum(0);
  const auto add = [&](double x, double z) { sum += glm::dvec3(x * x, z * z, x * z); };
  for (std::uint32_t j = 0; j < size_; ++j) {
    for (std::uint32_t i = 0; i < size_; ++i) {
      const double a = height(i, j), b = height(i + 1, j), c = height(i, j + 1), d = height(i + 1, j + 1);
      add(b - a, c - a);
      add(d - c, d - b);
    }
  }
  return sum / (2.0 * size_ * size_);
}

glm::dvec2 FacetedSea::slope(double x, double z) const {
  const auto i = static_cast<std::int64_t>(std::floor(x)), j = static_cast<std::int64_t>(std::floor(z));
  return {height(i + 1, j) - height(i, j), height(i, j + 1) - height(i, j)};
}

bool FacetedSea::intersectCell(std::int64_t i, std::int64_t j, const glm::dvec3& origin, const glm::dvec3& direction,
                               double from, double to, Hit& hit) const {
  const double a = height(i, j), b = height(i + 1, j), c = height(i, j + 1), d = height(i + 1, j + 1);
  const double lowest = origin.y + direction.y * (direction.y < 0 ? to : from);
  if (lowest > std::max(std::max(a, b), std::max(c, d))) return false;
  // The facets meet in the diagonal u + w = 1.
  const glm::dvec2 start = glm::dvec2(origin.x, origin.z) - glm::dvec2(i, j);
  const glm::dvec2 along(direction.x, direction.z);
  const auto side = [&](double t) { return start.x + start.y + t * (along.x + along.y) - 1; };
  const double middle = side(from) * side(to) < 0 ? from - side(from) / (along.x + along.y) : to;
  for (const auto& [low, high] : {std::pair{from, middle}, {middle, to}}) {
    if (!(high > low)) continue;
    const bool near = side(0.5 * (low + high)) < 0;
    const glm::dvec2 slope = near ? glm::dvec2(b - a, c - a) : glm::dvec2(d - c, d - b);
    const double height = near ? a : d - slope.x - slope.y;  // of the facet's plane, at the cell's corner
    const double above = origin.y - height - glm::dot(slope, start);
    const double rate = direction.y - glm::dot(slope, along);
    if (above + rate * high >= 0) continue;
    const double t = std::clamp(-above / rate, low, high);
    hit = {origin + t * direction, glm::normalize(glm::dvec3(-slope.x, 1, -slope.y))};
    return true;
  }
  return false;
}

bool FacetedSea::intersect(const glm::dvec3& origin, const glm::dvec3& direction, Hit& hit) const {
  constexpr double kNever = 1e30;
  double from = origin.y > top_ ? (top_ - origin.y) / direction.y : 0;
  if (from < 0) return false;
  const double end = direction.y > 0 ? (top_ - origin.y) / direction.y : kNever;
  const glm::dvec3 entry = origin + from * direction;
  std::int64_t cell[2] = {static_cast<std::int64_t>(std::floor(entry.x)),
                          static_cast<std::int64_t>(std::floor(entry.z))};
  double next[2], step[2];
  int sign[2];
  for (int axis = 0; axis < 2; ++axis) {
    const double rate = axis == 0 ? direction.x : direction.z;
    const double at = axis == 0 ? origin.x : origin.z;
    sign[axis] = rate < 0 ? -1 : 1;
    step[axis] = rate != 0 ? 1 / std::abs(rate) : kNever;
    const double edge = static_cast<double>(cell[axis] + (rate > 0 ? 1 : 0));
    next[axis] = rate != 0 ? (edge - at) / rate : kNever;
  }
  while (from < end) {
    const int axis = next[0] < next[1] ? 0 : 1;
    // Straight down a ray leaves no cell.
    const double to = std::min(next[axis], from + 2 * top_ / std::max(std::abs(direction.y), 1e-9) + 4);
    if (intersectCell(cell[0], cell[1], origin, direction, from, to, hit)) return true;
    from = next[axis];
    next[axis] += step[axis];
    cell[axis] += sign[axis];
  }
  return false;
}

SeaRadiance traceRay(const FacetedSea& sea, const SeaLighting& lighting, glm::dvec3 origin, glm::dvec3 direction) {
  SeaRadiance result;
  double weight = 1;
  FacetedSea::Hit hit;
  for (int bounce = 0; bounce < kBounces && sea.intersect(origin, direction, hit); ++bounce) {
    const double incidence = std::min(1.0, -glm::dot(direction, hit.normal));
    const double mirrored = static_cast<double>(
        pelagic::physics::fresnelReflectance(static_cast<float>(incidence), pelagic::physics::kWaterIndex));
    result.water += weight * (1 - mirrored) * lighting.waterRadiance;
    weight *= mirrored;
    direction += 2 * incidence * hit.normal;
    origin = hit.position;
  }
  if (direction.y <= 0) return result;  // after all bounces still between the waves
  result.sky = weight * lighting.sky(direction);
  if (glm::distance(direction, lighting.sunDirection) < 2 * std::sin(0.5 * lighting.sunRadius)) {
    const double solidAngle = kTwoPi * (1 - std::cos(lighting.sunRadius));
    result.sun = weight / solidAngle * lighting.sunIrradiance;
  }
  return result;
}

namespace {

/// Over the whole lattice: Roberts' (2018) sequence in two dimensions.
glm::dvec3 placeOver(const FacetedSea& sea, std::uint32_t i) {
  return {std::fmod(0.5 + i * 0.7548776662466927, 1.0) * sea.side(), sea.top(),
          std::fmod(0.5 + i * 0.5698402909980532, 1.0) * sea.side()};
}

}  // namespace

FacetedSea::Hit facetSeen(const FacetedSea& sea, const glm::dvec3& v, std::uint32_t i) {
  FacetedSea::Hit hit{};
  sea.intersect(placeOver(sea, i), -v, hit);
  return hit;
}

SeaRadiance traceSea(const FacetedSea& sea, const SeaLighting& lighting, const glm::dvec3& v, std::uint32_t rays) {
  SeaRadiance mean;
  for (std::uint32_t i = 0; i < rays; ++i) {
    const SeaRadiance one = traceRay(sea, lighting, placeOver(sea, i), -v);
    mean.sky += one.sky / static_cast<double>(rays);
    mean.sun += one.sun / static_cast<double>(rays);
    mean.water += one.water / static_cast<double>(rays);
  }
  return mean;
}

}  // namespace support
