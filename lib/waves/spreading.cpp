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

}  // namespace

double cosinePower(double s, double theta) noexcept {
  const double norm = gammaRatio(s) / (2 * std::sqrt(kPi));
  return norm * std::pow(std::abs(std::cos(0.5 * wrapped(theta))), 2 * s);
}

double spreading(Spreading kind, double relative, double inverseAge, double theta) noexcept {
  switch (kind) {
    case Spreading::cos2: {
      const double c = std::cos(theta);
      return c > 0 ? 2 / kPi * c * c : 0;
    }
    case Spreading::mitsuyasu: {
      const double peak = 11.5 * std::pow(inverseAge, -2.5);
      return cosinePower(peak * std::pow(relative, relative <= 1 ? 5.0 : -2.5), theta);
    }
    case Spreading::hasselmann: {
      const double s = relative < 1 ? 6.97 * std::pow(relative, 4.06)
                                    : 9.77 * std::pow(relative, -2.33 - 1.45 * (inverseAge - 1.17));
      return cosinePower(s, theta);
    }
    case Spreading::donelanBanner: {
      const double beta = donelanBannerBeta(relative);
      const double sech = 1 / std::cosh(beta * wrapped(theta));
      return beta > 1e-9 ? beta / (2 * std::tanh(beta * kPi)) * sech * sech : 1 / (2 * kPi);
    }
  }
  return 0;
}

}  // namespace pelagic
