#include <shared/query.h>

#include <algorithm>
#include <cmath>
#include <gpu/context.hpp>
#include <numbers>
#include <pelagic/query.hpp>
#include <waves/cpu_lattice.hpp>
#include <waves/gain_field.hpp>
#include <waves/surface_ray.hpp>
#include <waves/trochoids.hpp>
#include <waves/warp.hpp>

namespace pelagic {
namespace {

/// (Dx, h, Dz, dDz/dx) at a point of the undisplaced plane, and its slope between the texels there, in which the warp's
/// own, a few hundredths of it, is left out.
struct Local {
  Float4 value{};
  Float4 alongX{};  ///< Per metre.
  Float4 alongZ{};
};

/// `gain`: of the cascade there; null: 1 everywhere.
void addLocal(const CpuLattice& lattice, const Gain* gain, const glm::dvec2& point, Local& local) noexcept {
  const LatticePlace place = lattice.placeOf(point);
  const auto texel = [&](int i) { return float4Of(lattice.texels().displacement[place.corners[i]]); };
  const Float4 nearLow = texel(0);
  const Float4 farLow = texel(2);
  const Float4 nearRow = texel(1) - nearLow;
  const Float4 farRow = texel(3) - farLow;
  const Float4 low = nearLow + nearRow * place.x;
  const Float4 rise = farLow + farRow * place.x - low;
  const Float4 value = low + rise * place.z;
  const Float4 alongX = nearRow + (farRow - nearRow) * place.z;
  const auto perMetre = static_cast<float>(lattice.density());
  if (gain == nullptr) {
    local.value += value;
    local.alongX += perMetre * alongX;
    local.alongZ += perMetre * rise;
  } else {
    local.value += gain->value * value;
    local.alongX += gain->value * perMetre * alongX + gain->alongX * value;
    local.alongZ += gain->value * perMetre * rise + gain->alongZ * value;
  }
}

/// The water that is displaced to a place: its rest relative to the place [m], and its height [m].
struct Found {
  glm::vec2 offset{0};
  float height = 0;
};

}  // namespace

struct SeaQuery::Impl {
  WavesInfo info;
  Warp warp;
  double kMax = 0;
  double time = 0;
  SeaChange sea;
  double deviation = 0;  ///< Of the elevation [m].
  double largestGain = 1;
  double shortest = 0;  ///< Length of the finest cell [m].
  std::vector<CpuLattice> lattices;
  InverseFft fft;
  ComplexPlane plane, scratch;

  Impl(const WavesInfo& wanted, double shortestWavelength);
  void build(SeaChange change);
  void evolve() noexcept;
  /// `there`: the warp at `point`.
  Found find(const glm::dvec2& point, const LocalWarp& there) const noexcept;
  SurfacePoint surfaceAt(const glm::dvec2& point) const noexcept;
  double heightAt(const glm::dvec2& point) const noexcept {
    return static_cast<double>(find(point, warp.at(point)).height);
  }
};

SeaQuery::Impl::Impl(const WavesInfo& wanted, double shortestWavelength)
    : info(wanted),
      warp(wanted.layout, wanted.warp),
      kMax(shortestWavelength > 0 ? 2 * std::numbers::pi / shortestWavelength : HUGE_VAL),
      largestGain(pelagic::largestGain(wanted.gain)),
      fft(wanted.layout.size) {
  const std::size_t count = std::size_t{info.layout.size} * info.layout.size;
  for (auto* part : {&plane.re, &plane.im, &scratch.re, &scratch.im}) part->resize(count);
  SeaChange first;
  first.after = makeGridSea(info.sea, info);
  build(std::move(first));
}

void SeaQuery::Impl::build(SeaChange change) {
  std::vector<CpuLattice> built;
  for (std::uint32_t c = 0; c < info.layout.count && info.layout.cascades[c].kMin < kMax; ++c) {
    built.emplace_back(change, info, c, kMax);
  }
  lattices = std::move(built);
  sea = std::move(change);
  deviation = std::max(elevationDeviation(sea.after.moments), elevationDeviation(sea.before.moments));
  shortest = lattices.empty() ? 1 : 1 / lattices.back().density();
  evolve();
}

void SeaQuery::Impl::evolve() noexcept {
  const Share share = sea.share(time);
  for (CpuLattice& lattice : lattices) lattice.evolve(time, share, fft, plane, scratch);
}

Found SeaQuery::Impl::find(const glm::dvec2& point, const LocalWarp& there) const noexcept {
  Found found;
  for (std::uint32_t i = 0; i < shader::kNewtonSteps; ++i) {
    Local local;
    const glm::dvec2 rest = point + glm::dvec2(found.offset);
    const glm::dvec2 place = rest + glm::dvec2(there.shiftAt(found.offset));
    if (info.gain.width == 0) {
      for (const CpuLattice& lattice : lattices) addLocal(lattice, nullptr, place, local);
    } else {
      for (std::uint32_t c = 0; c < lattices.size(); ++c) {
        const Gain gain = gainAt(info.gain, c, rest);
        addLocal(lattices[c], &gain, place, local);
      }
    }
    const glm::vec2 miss = found.offset + glm::vec2(local.value[0], local.value[2]);
    const Float4& x = local.alongX;
    const Float4& z = local.alongZ;
    const float determinant = std::max((1 + x[0]) * (1 + z[2]) - x[2] * z[0], shader::kLeastJacobian);
    glm::vec2 step((1 + z[2]) * miss.x - z[0] * miss.y, (1 + x[0]) * miss.y - x[2] * miss.x);
    step *= 1 / -determinant;
    const float longest = shader::kLongestStep * shader::kLongestStep;
    if (glm::dot(step, step) > longest) step *= shader::kLongestStep / glm::length(step);
    found.offset += step;
    found.height = local.value[1] + x[1] * step.x + z[1] * step.y;
    if (glm::dot(miss, miss) < shader::kLeastMiss * shader::kLeastMiss) break;
  }
  return found;
}

SurfacePoint SeaQuery::Impl::surfaceAt(const glm::dvec2& point) const noexcept {
  SurfacePoint result;
  const LocalWarp there = warp.at(point);
  const Found found = find(point, there);
  const glm::dvec2 p = point + glm::dvec2(found.offset);
  const glm::dvec2 place = p + glm::dvec2(there.shiftAt(found.offset));
  // P_x and P_z of P = (x + Dx, h, z + Dz), where h and D carry a gain that has slopes of its own, and its derivatives
  // over the patches.
  glm::dvec3 alongX(1, 0, 0);
  glm::dvec3 alongZ(0, 0, 1);
  glm::dmat2x3 patch(0);
  for (std::uint32_t c = 0; c < lattices.size(); ++c) {
    const LatticePlace on = lattices[c].placeOf(place);
    const LatticeTexels& texels = lattices[c].texels();
    const Gain gain = gainAt(info.gain, c, p);
    const glm::vec4 d = on.value(texels.displacement);
    const glm::vec4 g = on.value(texels.gradient);
    patch += glm::dmat2x3(gain.value * glm::mat2x3(g.z, g.x, d.w, d.w, g.y, g.w));
    alongX += gain.alongX * glm::vec3(d);
    alongZ += gain.alongZ * glm::vec3(d);
    result.velocity += gain.value * glm::vec3(on.value(texels.velocity));
    result.acceleration += gain.value * glm::vec3(on.value(texels.acceleration));
  }
  result.position = {point.x, static_cast<double>(found.height), point.y};
  result.undisplaced = p;
  const glm::dmat2 stretch = glm::dmat2(1) + glm::dmat2(there.slopes);
  alongX += patch * stretch[0];
  alongZ += patch * stretch[1];
  const glm::dvec3 normal = glm::cross(alongZ, alongX);
  const double length = glm::length(normal);
  if (length > 0) result.normal = normal / length;
  return result;
}

SeaQuery::SeaQuery(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
SeaQuery::SeaQuery(SeaQuery&&) noexcept = default;
SeaQuery& SeaQuery::operator=(SeaQuery&&) noexcept = default;
SeaQuery::~SeaQuery() = default;

Result<SeaQuery> SeaQuery::create(const WavesInfo& info, double shortestWavelength) {
  PELAGIC_CHECK(validate(info));
  if (!(shortestWavelength >= 0 && shortestWavelength <= 1e4)) {
    return gpu::reject("the shortest wavelength is " + std::to_string(shortestWavelength) +
                       " m, it must lie in 0 … 10000 m");
  }
  return SeaQuery(std::make_unique<Impl>(info, shortestWavelength));
}

Result<void> SeaQuery::setSea(const SeaState& sea, const SeaTransition& transition) {
  PELAGIC_CHECK(validate(sea));
  PELAGIC_CHECK(validate(sea, impl_->info.layout));
  PELAGIC_CHECK(validate(transition));
  impl_->build(changeSea(impl_->sea, makeGridSea(sea, impl_->info), transition, impl_->info));
  return {};
}

Result<void> SeaQuery::setGain(const GainMap& map) {
  PELAGIC_CHECK(validate(map, impl_->info.layout.count));
  impl_->info.gain = map;
  impl_->largestGain = largestGain(map);
  return {};
}

void SeaQuery::setTime(double time) noexcept {
  if (time == impl_->time || !std::isfinite(time)) return;
  impl_->time = time;
  impl_->evolve();
}

SurfacePoint SeaQuery::at(const glm::dvec2& point) const noexcept {
  if (onEarth(point)) return impl_->surfaceAt(point);
  SurfacePoint none;
  none.position = glm::dvec3(point.x, std::nan(""), point.y);
  return none;
}

double SeaQuery::heightAt(const glm::dvec2& point) const noexcept {
  return onEarth(point) ? impl_->heightAt(point) : std::nan("");
}

void SeaQuery::heightsAt(std::span<const glm::dvec2> points, std::span<double> heights) const noexcept {
  // The maps do not fit the nearest cache: all that a group needs is fetched side by side.
  constexpr std::size_t kGroup = 16;
  const Impl& sea = *impl_;
  const std::size_t count = std::min(points.size(), heights.size());
  for (std::size_t first = 0; first < count; first += kGroup) {
    const std::size_t end = std::min(first + kGroup, count);
    std::array<LocalWarp, kGroup> warps;
    for (std::size_t i = first; i < end; ++i) {
      if (!onEarth(points[i])) continue;
      LocalWarp& there = warps[i - first] = sea.warp.at(points[i]);
      for (const CpuLattice& lattice : sea.lattices) {
        lattice.prefetch(lattice.placeOf(points[i] + glm::dvec2(there.shift)));
      }
    }
    for (std::size_t i = first; i < end; ++i) {
      const bool exists = onEarth(points[i]);
      heights[i] = exists ? static_cast<double>(sea.find(points[i], warps[i - first]).height) : std::nan("");
    }
  }
}

std::optional<SurfacePoint> SeaQuery::intersect(const glm::dvec3& origin, const glm::dvec3& direction,
                                                double reach) const noexcept {
  const Impl& sea = *impl_;
  const std::optional<RayPart> part = partAtSea(origin, direction, reach, sea.deviation * sea.largestGain);
  if (!part) return {};
  const glm::dvec3 d = part->direction;
  const auto gap = [&](double t) {
    const glm::dvec3 p = origin + t * d;
    return p.y - sea.heightAt({p.x, p.z});
  };
  constexpr auto kSteepestFace = static_cast<double>(shader::kSteepestFace);
  const double speed = std::abs(d.y) + kSteepestFace * std::hypot(d.x, d.z);
  const double to = part->to;
  double t = part->from;
  double g = gap(t);
  const bool above = g >= 0;
  while (t < to) {
    const double next = std::min(t + std::max(std::abs(g) / speed, 0.5 * sea.shortest), to);
    const double ahead = gap(next);
    if (!std::isfinite(ahead)) return {};
    if ((ahead >= 0) != above) {
      double low = t;
      double high = next;
      for (int i = 0; i < 60 && high - low > 1e-9 * (1 + high); ++i) {
        const double middle = 0.5 * (low + high);
        ((gap(middle) >= 0) == above ? low : high) = middle;
      }
      const glm::dvec3 hit = origin + high * d;
      return at({hit.x, hit.z});
    }
    t = next;
    g = ahead;
  }
  return {};
}

}  // namespace pelagic
