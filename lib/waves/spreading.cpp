#include <cmath>
#include <numbers>
#include <waves/spreading.hpp>

namespace pelagic {
namespace {

constexpr double kPi = std::numbers::pi;

/// Gamma(s+1) / Gamma(s+1/2) by its asymptotic series in 1/(s+1/4)^2 (Tricomi & Erdelyi 1951), after the recurrence has
/// raised the argument to 8, where the dropped terms are below 1e-10. std::lgamma is not used: it writes a global.
double gammaRatio(double s) noexcept {
  double factor = 1;
  for (; s < 8; s += 1) factor *= (s + 0.5) / (s + 1);
  const double x = 1 / (s + 0.25);
  const double x2 = x * x;
  return factor * std::sqrt(s + 0.25) * (1 + x2 * (1.0 / 64 + x2 * (-19.0 / 8192 + x2 * (631.0 / 524288))));
}

double wrapped(double theta) noexcept { return std::remainder(theta, 2 * kPi); }

/// Donelan, Hamilton & Hui (1985) with the tail of Banner (1990).
double donelanBannerBeta(double relative) noexcept {
  if (relative < 0.95) return 2.61 * std::pow(relative, 1.3);
  if (relative < 1.6) return 2.28 * std::pow(relative, -1.3);
  return std::pow(10.0, -0.4 + 0.8393 * std::exp(-0.567 * std::log(relative * relative)));
}

/// The kind's own function without norm.
double rawDirections(Spreading kind, double shape, double theta) noexcept {
  switch (kind) {
    case Spreading::cos2: {
      const double c = std::cos(theta);
      return c > 0 ? c * c : 0;
    }
    case Spreading::mitsuyasu:
    case Spreading::hasselmann:
      return std::pow(std::abs(std::cos(0.5 * wrapped(theta))), 2 * shape);
    case Spreading::donelanBanner: {
      const double sech = 1 / std::cosh(shape * wrapped(theta));
      return sech * sech;
    }
    case Spreading::elfouhaily: {
      const double c = std::cos(theta);
      return c > 0 ? 1 + shape * (2 * c * c - 1) : 0;
    }
  }
  return 0;
}

double cosineNorm(double s) noexcept { return gammaRatio(s) / (2 * std::sqrt(kPi)); }

/// 1 / integral of an even function over all angles, by Simpson's rule on both sides of 90 degrees, where some have an
/// edge.
double quadratureNorm(const Directions& directions) noexcept {
  constexpr int kSteps = 64;  // the narrowest sech^2 is 0.4 rad wide
  constexpr double kInside = 1e-9;
  double sum = 0;
  for (const double from : {0.0, kPi / 2}) {
    const double first = from + kInside;
    const double step = (kPi / 2 - 2 * kInside) / kSteps;
    for (int i = 0; i <= kSteps; ++i) {
      sum += (i == 0 || i == kSteps ? 1 : (i % 2 ? 4 : 2)) * step / 3 * directions(first + step * i);
    }
  }
  return 1 / (2 * sum);
}

}  // namespace

double cosinePower(double s, double theta) noexcept {
  return cosineNorm(s) * rawDirections(Spreading::hasselmann, s, theta);
}

double Directions::operator()(double theta) const noexcept {
  const double raw = norm * rawDirections(kind, shape, theta);
  return sharpen > 0 ? raw * rawDirections(Spreading::hasselmann, sharpen, theta) : raw;
}

Directions directionsAt(Spreading kind, const SpreadingPoint& point) noexcept {
  Directions result{kind, 0, point.sharpen, 1};
  switch (kind) {
    case Spreading::cos2:
      result.norm = 2 / kPi;
      break;
    case Spreading::mitsuyasu:
    case Spreading::hasselmann: {
      const double x = point.relative;
      const double mitsuyasu = 11.5 * std::pow(point.inverseAge, -2.5) * std::pow(x, x <= 1 ? 5.0 : -2.5);
      const double hasselmann =
          x < 1 ? 6.97 * std::pow(x, 4.06) : 9.77 * std::pow(x, -2.33 - 1.45 * (point.inverseAge - 1.17));
      // Exponents of cos^2s(theta/2) add up.
      result.shape = (kind == Spreading::mitsuyasu ? mitsuyasu : hasselmann) + point.sharpen;
      result.sharpen = 0;
      result.norm = cosineNorm(result.shape);
      break;
    }
    case Spreading::donelanBanner: {
      const double beta = donelanBannerBeta(point.relative);
      result.shape = beta;
      result.norm = beta > 1e-9 ? beta / (2 * std::tanh(beta * kPi)) : 1 / (2 * kPi);
      break;
    }
    case Spreading::elfouhaily:
      result.shape = point.asymmetry;
      result.norm = 1 / kPi;
      break;
  }
  if (result.sharpen > 0) result.norm *= quadratureNorm(result);
  return result;
}

}  // namespace pelagic
