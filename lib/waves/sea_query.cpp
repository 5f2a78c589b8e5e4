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

namespace pelagic {
namespace {

/// (Dx, h, Dz, dDz/dx) at a point of the undisplaced plane, and its slope between the texels there.
struct Local {
  glm::vec4 value{0};
  glm::vec4 alongX{0};  ///< Per metre.
  glm::vec4 alongZ{0};
};

void addLocal(const CpuLattice& lattice, const Gain& gain, const glm::dvec2& point, Local& local) noexcept {
  const LatticePlace place = lattice.placeOf(point);
  const auto& texels = lattice.texels().displacement;
  const glm::vec4 nearRow = texels[place.corners[1]] - texels[place.corners[0]];
  const glm::vec4 farRow = texels[place.corners[3]] - texels[place.corners[2]];
  const glm::vec4 low = texels[place.corners[0]] + nearRow * place.x;
  const glm::vec4 rise = texels[place.corners[2]] + farRow * place.x - low;
  const auto perMetre = static_cast<float>(lattice.density());
  const glm::vec4 value = low + rise * place.z;
  local.value += gain.value * value;
  local.alongX += gain.value * (nearRow + (farRow - nearRow) * place.z) * perMetre + gain.alongX * value;
  local.alongZ += gain.value * rise * perMetre + gain.alongZ * value;
}

/// The water that is displaced to a place, p + D(p) = place.
struct Found {
  glm::dvec2 undisplaced{0};
  double height = 0;
};

}  // namespace

struct SeaQuery::Impl {
  WavesInfo info;
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
  Found find(const glm::dvec2& point) const noexcept;
  SurfacePoint surfaceAt(const glm::dvec2& point) const noexcept;
  double heightAt(const glm::dvec2& point) const noexcept { return find(point).height; }
};

SeaQuery::Impl::Impl(const WavesInfo& wanted, double shortestWavelength)
    : info(wanted),
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

Found SeaQuery::Impl::find(const glm::dvec2& point) const noexcept {
  constexpr auto kLeastJacobian = static_cast<double>(shader::kLeastJacobian);
  constexpr auto kLongestStep = static_cast<double>(shader::kLongestStep);
  constexpr auto kLeastMiss = static_cast<double>(shader::kLeastMiss);
  Found found{point, 0};
  for (std::uint32_t i = 0; i < shader::kNewtonSteps; ++i) {
    Local local;
    for (std::uint32_t c = 0; c < lattices.size(); ++c) {
      addLocal(lattices[c], gainAt(info.gain, c, found.undisplaced), found.undisplaced, local);
    }
    const glm::dvec2 miss = found.undisplaced + glm::dvec2(local.value.x, local.value.z) - point;
    const glm::dvec4 x(local.alongX);
    const glm::dvec4 z(local.alongZ);
    const double determinant = std::max((1 + x.x) * (1 + z.z) - x.z * z.x, kLeastJacobian);
    glm::dvec2 step = glm::dvec2((1 + z.z) * miss.x - z.x * miss.y, (1 + x.x) * miss.y - x.z * miss.x) / -determinant;
    step *= kLongestStep / std::max(glm::length(step), kLongestStep);
    found.undisplaced += step;
    found.height = static_cast<double>(local.value.y) + x.y * step.x + z.y * step.y;
    if (glm::dot(miss, miss) < kLeastMiss * kLeastMiss) break;
  }
  return found;
}

SurfacePoint SeaQuery::Impl::surfaceAt(const glm::dvec2& point) const noexcept {
  SurfacePoint result;
  const Found found = find(point);
  const glm::dvec2 p = found.undisplaced;
  // P_x and P_z of P = (x + Dx, h, z + Dz), where h and D carry a gain that has slopes of its own.
  glm::dvec3 alongX(1, 0, 0);
  glm::dvec3 alongZ(0, 0, 1);
  for (std::uint32_t c = 0; c < lattices.size(); ++c) {
    const LatticePlace place = lattices[c].placeOf(p);
    const LatticeTexels& texels = lattices[c].texels();
    const Gain gain = gainAt(info.gain, c, p);
    const glm::vec4 d = place.value(texels.displacement);
    const glm::vec4 g = place.value(texels.gradient);
    alongX += gain.value * glm::vec3(g.z, g.x, d.w) + gain.alongX * glm::vec3(d);
    alongZ += gain.value * glm::vec3(d.w, g.y, g.w) + gain.alongZ * glm::vec3(d);
    result.velocity += gain.value * glm::vec3(place.value(texels.velocity));
    result.acceleration += gain.value * glm::vec3(place.value(texels.acceleration));
  }
  result.position = {point.x, found.height, point.y};
  result.undisplaced = p;
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
