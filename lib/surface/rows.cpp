#include <algorithm>
#include <cmath>
#include <surface/rows.hpp>

namespace pelagic::surface {
namespace {

/// Mean of 1/W over a stretch on which W runs linearly from a to b.
double meanInverse(double a, double b) noexcept {
  const double x = b / a - 1;
  return (std::abs(x) < 1e-6 ? 1 - x / 2 : std::log1p(x) / x) / a;
}

}  // namespace

double RowDensity::width(double z) const noexcept { return std::max(slope * z + offset, floor); }

double RowDensity::density(double z) const noexcept {
  const double w = width(z);
  const double waves = w < reach ? (1 / w - 1 / reach) / (kAspect * step) : 0;
  return height / (step * w * w) + waves + curvature / std::sqrt(w);
}

double RowDensity::count(double from, double to) const noexcept {
  // W is constant up to the bend and linear beyond it.
  const bool linear = slope > 1e-9;
  const double bend = linear ? std::clamp((floor - offset) / slope, from, to) : to;
  double rows = density(from) * (bend - from);
  if (bend >= to) return rows;
  const double a = width(bend);
  const double b = width(to);
  rows += height / step * (to - bend) / (a * b);
  rows += curvature * 2 * (to - bend) / (std::sqrt(a) + std::sqrt(b));
  if (a < reach) {
    const double end = std::min(b, reach);
    rows += (end - a) / slope * (meanInverse(a, end) - 1 / reach) / (kAspect * step);
  }
  return rows;
}

double RowDensity::before(double z) const noexcept {
  // With the first demand alone the answer is exact; it lies too far away for all three, from where Newton's iteration
  // on the convex count() comes back without overshooting.
  const double w = width(z);
  const double inverse = 1 / w + slope * step / height;
  double guess = slope > 1e-9 ? (1 / inverse - offset) / slope : z - step * w * w / height;
  if (slope * guess + offset < floor) guess = std::min(guess, z) - step * floor * floor / height;
  guess = std::min(guess, z);
  for (int i = 0; i < 30; ++i) {
    const double excess = count(guess, z) - 1;
    guess += excess / density(guess);
    if (std::abs(excess) < 1e-9) break;
  }
  return guess;
}

}  // namespace pelagic::surface
