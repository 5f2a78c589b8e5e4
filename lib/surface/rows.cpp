#include <algorithm>
#include <cmath>
#include <surface/rows.hpp>

#include "physics/sheet.glsl"

namespace pelagic::surface {
namespace {

constexpr double kLongestCell{physics::kLongestCell}, kFlatter{physics::kFlatter};

/// Mean of 1/W over a stretch on which W runs linearly from a to b.
double meanInverse(double a, double b) noexcept {
  const double x = b / a - 1;
  return (std::abs(x) < 1e-6 ? 1 - x / 2 : std::log1p(x) / x) / a;
}

}  // namespace

std::array<double, 2> RowDensity::bends() const noexcept {
  constexpr double kNever = 1e12;  // farther than any water [m]
  const double bend =
      slope > 1e-9 ? std::clamp((floor - offset) / slope, -kNever, kNever) : (offset >= floor ? -kNever : kNever);
  return {bend - floor, bend};
}

double RowDensity::width(double z) const noexcept {
  const double bend = bends()[1];
  return z >= bend ? std::max(slope * z + offset, floor) : std::min(floor + (bend - z), 2 * floor);
}

double RowDensity::density(double z) const noexcept {
  const double w = width(z);
  const double waves = w < reach ? 1 - w / reach : 0;
  const double rows{physics::rowsPerWidth(static_cast<float>(height / w), static_cast<float>(waves))};
  return rows / (step * w) + curvature / std::sqrt(w);
}

double RowDensity::count(double from, double to) const noexcept {
  double rows = 0;
  for (const double bend : bends()) {
    const double end = std::clamp(bend, from, to);
    rows += linearCount(from, end);
    from = end;
  }
  return rows + linearCount(from, to);
}

double RowDensity::linearCount(double from, double to) const noexcept {
  if (!(from < to)) return 0;
  const double a = width(from);
  const double b = width(to);
  double rows = (to - from) * (height / (step * a * b) + 2 * curvature / (std::sqrt(a) + std::sqrt(b)));
  // The waves' demand has one form up to `turn` and another from there to `reach`.
  const double turn = std::min(kFlatter * kLongestCell * height, reach);
  const double low = std::min(a, b);
  const double high = std::max(a, b);
  const auto stretch = [&](double wa, double wb) {
    return high - low > 1e-12 * low ? (to - from) * (wb - wa) / (high - low) : (to - from);
  };
  if (low < turn) {
    const double end = std::min(high, turn);
    rows += stretch(low, end) * (meanInverse(low, end) - 1 / reach) / (kLongestCell * step);
  }
  if (low < reach && high > turn) {
    const double start = std::max(low, turn);
    const double end = std::min(high, reach);
    rows += stretch(start, end) * (1 / (start * end) - meanInverse(start, end) / reach) * kFlatter * height / step;
  }
  return rows;
}

double RowDensity::before(double z) const noexcept {
  // Bracketed Newton iteration; the first guess is right where the first demand alone counts.
  const double w = width(z);
  const double inverse = 1 / w + slope * step / height;
  double low = z;
  double stride = step * w * w / height;
  if (z > bends()[1] && slope > 1e-9) stride = std::min(stride, z - (1 / inverse - offset) / slope);
  do {
    low -= stride;
    stride *= 2;
  } while (count(low, z) < 1);
  double high = z;
  double guess = low;
  for (int i = 0; i < 60; ++i) {
    const double excess = count(guess, z) - 1;
    if (std::abs(excess) < 1e-9) break;
    (excess > 0 ? low : high) = guess;
    guess += excess / density(guess);
    if (!(guess > low && guess < high)) guess = 0.5 * (low + high);
  }
  return guess;
}

}  // namespace pelagic::surface
