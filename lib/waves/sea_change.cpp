#include <algorithm>
#include <cmath>
#include <complex>
#include <gpu/context.hpp>
#include <numbers>
#include <sstream>
#include <waves/sea_change.hpp>

namespace pelagic {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

SlopeVariance mix(const SlopeVariance& a, const SlopeVariance& b, double share) noexcept {
  return {glm::mix(a.upwind, b.upwind, share), glm::mix(a.crosswind, b.crosswind, share)};
}

/// Energy that a mode and its opposite bring to the elevation [m^2].
double energyOf(const glm::vec4& amplitude) noexcept { return static_cast<double>(glm::dot(amplitude, amplitude)); }

/// Moments of the differences of two seas' amplitudes.
SeaMoments differenceOf(const GridSea& a, const GridSea& b, const WavesInfo& info) {
  SeaMoments sum;
  const std::size_t count = std::size_t{info.layout.size} * info.layout.size;
  CascadeModes modes;
  modes.variance.resize(count);
  for (std::uint32_t c = 0; c < info.layout.count; ++c) {
    const auto offset = static_cast<std::ptrdiff_t>(c * count);
    modes.constants.assign(b.constants.begin() + offset,
                           b.constants.begin() + offset + static_cast<std::ptrdiff_t>(count));
    for (std::size_t i = 0; i < count; ++i) {
      modes.variance[i] = energyOf(a.amplitudes[c * count + i] - b.amplitudes[c * count + i]);
    }
    const CascadeMoments moments = momentsOf(modes, info.layout.cascades[c], info.layout.size);
    sum.elevation += moments.elevation;
    sum.horizontal += moments.horizontal;
    sum.slopes[c] = moments.slopes;
  }
  return sum;
}

/// The mode of both seas at a moment, turning from then on as the later one does.
glm::vec4 frozen(const glm::vec4& before, const glm::vec4& after, float share, double lag) noexcept {
  const auto turn = std::polar(1.0, lag);
  const glm::vec2 e(static_cast<float>(turn.real()), static_cast<float>(turn.imag()));
  const glm::vec2 forward = times({before.x, before.y}, {e.x, -e.y});
  const glm::vec2 backward = times({before.z, before.w}, e);
  return glm::mix(glm::vec4(forward, backward), after, share);
}

/// The mixture of a change at `time` as one sea.
GridSea freeze(const SeaChange& change, double time, double loopPeriod) {
  const double share = change.share(time).value;
  if (!change.changing() || share >= 1) return change.after;
  if (share <= 0) return change.before;
  GridSea sea = change.after;
  const auto part = static_cast<float>(share);
  const std::uint64_t fraction = loopFraction(time, loopPeriod);
  for (std::size_t i = 0; i < sea.amplitudes.size(); ++i) {
    const ModeConstants& before = change.before.constants[i];
    ModeConstants& after = sea.constants[i];
    // The angle by which the earlier sea's mode has turned farther, in wrapping integers.
    const auto lag = static_cast<std::int64_t>((std::uint64_t{before.cycles} - after.cycles) * fraction);
    const float weightBefore = (1 - part) * glm::length(change.before.amplitudes[i]);
    const float weightAfter = part * glm::length(change.after.amplitudes[i]);
    sea.amplitudes[i] = frozen(change.before.amplitudes[i], change.after.amplitudes[i], part,
                               kTwoPi * 0x1p-64 * static_cast<double>(lag));
    const float both = weightBefore + weightAfter;
    if (both > 0) after.chop = (weightBefore * before.chop + weightAfter * after.chop) / both;
  }
  for (std::size_t c = 0; c < sea.cascades.size(); ++c) {
    shader::WaveCascade& cascade = sea.cascades[c];
    const shader::WaveCascade& before = change.before.cascades[c];
    cascade.heightScale = glm::mix(before.heightScale, cascade.heightScale, part);
    cascade.foldThreshold = glm::mix(before.foldThreshold, cascade.foldThreshold, part);
    cascade.inverseSpread = glm::mix(before.inverseSpread, cascade.inverseSpread, part);
  }
  sea.moments = change.momentsAt(share);
  sea.foamDecline = change.foamDeclineAt(share);
  sea.report.unresolved = change.unresolvedAt(share);
  sea.sea.windDirection = change.windDirectionAt(share);
  sea.sea.windSpeed = change.windSpeedAt(share);
  sea.sea.choppiness = change.choppinessAt(share);
  return sea;
}

}  // namespace

Result<void> validate(const SeaTransition& transition) {
  std::ostringstream text;
  if (!std::isfinite(transition.start)) {
    text << "SeaTransition::start is " << transition.start << ", it must be finite";
    return gpu::reject(text.str());
  }
  if (!(transition.seconds >= 0 && transition.seconds <= 1e6)) {
    text << "SeaTransition::seconds is " << transition.seconds << ", it must lie in 0 … 1e6 s";
    return gpu::reject(text.str());
  }
  return {};
}

Share shareAt(const SeaTransition& transition, double time) noexcept {
  const double t = (time - transition.start) / transition.seconds;
  if (!(t > 0)) return {0, 0, 0};
  if (t >= 1) return {};
  // The least polynomial with speed and acceleration zero at both ends.
  return {t * t * t * (10 + t * (6 * t - 15)), 30 * t * t * (1 - t) * (1 - t) / transition.seconds,
          60 * t * (1 - t) * (1 - 2 * t) / (transition.seconds * transition.seconds)};
}

SeaMoments SeaChange::momentsAt(double share) const noexcept {
  if (!changing()) return after.moments;
  // |(1 - s) a + s b|^2 = (1 - s) |a|^2 + s |b|^2 - s (1 - s) |a - b|^2
  const double both = share * (1 - share);
  const SeaMoments &a = before.moments, &b = after.moments;
  SeaMoments mixed;
  const auto least = [&](double from, double to, double apart) {
    return std::max(0.0, glm::mix(from, to, share) - both * apart);
  };
  mixed.elevation = least(a.elevation, b.elevation, difference.elevation);
  mixed.horizontal = least(a.horizontal, b.horizontal, difference.horizontal);
  mixed.trochoidHeight = glm::mix(a.trochoidHeight, b.trochoidHeight, share);
  mixed.trochoidReach = glm::mix(a.trochoidReach, b.trochoidReach, share);
  for (std::size_t c = 0; c < mixed.slopes.size(); ++c) {
    // The difference is that of the random numbers drawn: of few modes it may exceed what is expected.
    glm::dvec3& slopes = mixed.slopes[c];
    slopes = glm::mix(a.slopes[c], b.slopes[c], share) - both * difference.slopes[c];
    slopes = glm::dvec3(std::max(0.0, slopes.x), std::max(0.0, slopes.y), slopes.z);
    const double most = std::sqrt(slopes.x * slopes.y);
    slopes.z = std::clamp(slopes.z, -most, most);
    for (std::size_t mip = 0; mip < mixed.interpolationLoss[c].size(); ++mip) {
      mixed.interpolationLoss[c][mip] = glm::mix(a.interpolationLoss[c][mip], b.interpolationLoss[c][mip], share);
      mixed.resolvedShare[c][mip] = glm::mix(a.resolvedShare[c][mip], b.resolvedShare[c][mip], share);
    }
  }
  return mixed;
}

SlopeVariance SeaChange::unresolvedAt(double share) const noexcept {
  return changing() ? mix(before.report.unresolved, after.report.unresolved, share) : after.report.unresolved;
}

double SeaChange::windDirectionAt(double share) const noexcept {
  return (changing() && share < 0.5 ? before : after).sea.windDirection;
}

double SeaChange::windSpeedAt(double share) const noexcept {
  return changing() ? glm::mix(before.sea.windSpeed, after.sea.windSpeed, share) : after.sea.windSpeed;
}

double SeaChange::choppinessAt(double share) const noexcept {
  return changing() ? glm::mix(before.sea.choppiness, after.sea.choppiness, share) : after.sea.choppiness;
}

double SeaChange::foamDeclineAt(double share) const noexcept {
  return changing() ? glm::mix(before.foamDecline, after.foamDecline, share) : after.foamDecline;
}

SeaChange changeSea(const SeaChange& now, GridSea next, const SeaTransition& transition, const WavesInfo& info) {
  SeaChange change;
  change.after = std::move(next);
  change.transition = transition;
  if (transition.seconds > 0) {
    change.before = freeze(now, transition.start, info.loopPeriod);
    change.difference = differenceOf(change.before, change.after, info);
  }
  return change;
}

}  // namespace pelagic
