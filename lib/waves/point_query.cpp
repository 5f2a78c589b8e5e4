#include <shared/query.h>

#include <bit>
#include <cmath>
#include <pelagic/point_query.hpp>
#include <waves/motion.hpp>
#include <waves/surface_ray.hpp>
#include <waves/warp.hpp>
#include <waves/waves_impl.hpp>

#include "waves_query_points.spv.hpp"
#include "waves_query_rays.spv.hpp"

namespace pelagic {
namespace {

using vk::DescriptorType;

enum Binding : std::uint32_t { bDisplacement, bGradient, bMoments, bMotion, bStarts, bRays, bResults, bGain, bWarp };

using Turns = glm::uvec2;  ///< A place in a patch, 2^32 along each side.

std::uint32_t turnsOf(double x, double length) noexcept {
  const double patches = x / length;
  // 1, the rounding of a share just below, becomes 0.
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>((patches - std::floor(patches)) * 0x1p32));
}

Result<void> validate(const PointQueryInfo& info) {
  const auto check = [](const char* field, std::uint32_t value, std::uint32_t most) -> Result<void> {
    if (value >= 1 && value <= most) return {};
    return gpu::reject("PointQueryInfo::" + std::string(field) + " is " + std::to_string(value) +
                       ", it must lie in 1 … " + std::to_string(most));
  };
  PELAGIC_CHECK(check("capacity", info.capacity, 1000000));
  return check("callsInFlight", info.callsInFlight, 16);
}

}  // namespace

struct PointQuery::Impl {
  enum class Kind { points, rays };
  /// What one call is told and answers.
  struct Call {
    gpu::Buffer starts, rays, results;
    std::array<gpu::DescriptorSet, 2> sets;  ///< [of WaveImages::displacement]
    std::vector<glm::dvec2> origins;         ///< (x, z) of the starts [m].
    std::vector<bool> exists;                ///< Whether there can be an answer.
    std::uint64_t ticket = 0;                ///< 0: none yet.
    Kind kind{};
  };

  gpu::Context* context = nullptr;
  Waves::Impl* waves = nullptr;
  PointQueryInfo info;
  gpu::Unique<vk::Sampler> sampler;
  std::optional<Warp> warp;
  gpu::Buffer warpStill;  ///< Its parts that do not depend on the place.
  gpu::Buffer still;      ///< Stands for the motion where there is none.
  WaveMotion motion;
  std::uint64_t movedTo = 0;  ///< The recording of the waves whose motion is there.
  gpu::ComputePass pointPass, rayPass;
  std::vector<Call> calls;
  std::uint64_t newest = 0;  ///< Ticket.

  Result<void> createPasses();
  Result<void> createCall(Call& call, std::uint32_t index);
  Result<Call*> begin(std::size_t count, const char* name, Kind kind);
  void start(Call& call, std::size_t item, std::size_t count, const glm::dvec2& place) const noexcept;
  void dispatch(vk::CommandBuffer commands, Call& call, std::size_t count) noexcept;
  Result<const Call*> find(std::uint64_t ticket, std::size_t count, Kind kind) const;
  SurfacePoint pointOf(const Call& call, std::size_t item) const noexcept;
};

PointQuery::PointQuery(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
PointQuery::PointQuery(PointQuery&&) noexcept = default;
PointQuery& PointQuery::operator=(PointQuery&&) noexcept = default;
PointQuery::~PointQuery() = default;

Result<void> PointQuery::Impl::createPasses() {
  const gpu::Binding bindings[] = {{bDisplacement, DescriptorType::eCombinedImageSampler},
                                   {bGradient, DescriptorType::eCombinedImageSampler},
                                   {bMoments, DescriptorType::eCombinedImageSampler},
                                   {bMotion, DescriptorType::eStorageBuffer},
                                   {bStarts, DescriptorType::eStorageBuffer},
                                   {bRays, DescriptorType::eStorageBuffer},
                                   {bResults, DescriptorType::eStorageBuffer},
                                   {bGain, DescriptorType::eCombinedImageSampler},
                                   {bWarp, DescriptorType::eStorageBuffer}};
  const WaveLayout& layout = waves->info.layout;
  const std::uint32_t constants[] = {layout.size, layout.count, info.motion ? 1u : 0u, waves->gain.width > 0 ? 1u : 0u};
  PELAGIC_TRY(points, gpu::ComputePass::create(*context, {"query points", shaders::waves_query_points, bindings,
                                                          sizeof(shader::QueryPush), constants}));
  PELAGIC_TRY(rays, gpu::ComputePass::create(*context, {"query rays", shaders::waves_query_rays, bindings,
                                                        sizeof(shader::QueryPush), constants}));
  pointPass = std::move(points);
  rayPass = std::move(rays);
  return {};
}

Result<void> PointQuery::Impl::createCall(Call& call, std::uint32_t index) {
  using Placement = gpu::Buffer::Placement;
  const auto create = [&](gpu::Buffer& buffer, const char* name, vk::DeviceSize size,
                          Placement placement) -> Result<void> {
    PELAGIC_TRY(made, gpu::Buffer::create(*context, Stage::waves, name + std::to_string(index), size,
                                          vk::BufferUsageFlagBits::eStorageBuffer, placement));
    buffer = std::move(made);
    return {};
  };
  const vk::DeviceSize capacity = info.capacity;
  constexpr std::uint32_t kPhasePairs = 4;
  PELAGIC_CHECK(create(call.starts, "query starts ",
                       sizeof(Turns) * (waves->info.layout.count + 1 + kPhasePairs) * capacity, Placement::upload));
  PELAGIC_CHECK(create(call.rays, "query rays ", sizeof(shader::QueryRay) * capacity, Placement::upload));
  PELAGIC_CHECK(create(call.results, "query results ", sizeof(shader::QueryResult) * capacity, Placement::readback));
  call.origins.reserve(info.capacity);
  call.exists.reserve(info.capacity);
  const WaveImages& images = waves->images;
  for (std::uint32_t i = 0; i < call.sets.size(); ++i) {
    // Both passes have one layout, so that one set fits them.
    PELAGIC_TRY(set, pointPass.createSet("query"));
    set.sampled(bDisplacement, images.displacement[i].view(), *sampler);
    set.sampled(bGradient, images.gradient.view(), *sampler);
    set.sampled(bMoments, images.moments.view(), *sampler);
    set.buffer(bMotion, (info.motion ? motion.texels() : still).handle());
    set.buffer(bStarts, call.starts.handle());
    set.buffer(bRays, call.rays.handle());
    set.buffer(bResults, call.results.handle());
    // Bound to something where there is no map, and untouched.
    const VkImageView gain = waves->gainImage.map().view;
    set.sampled(bGain, gain ? gain : VkImageView(images.displacement[i].view()), *sampler);
    set.buffer(bWarp, warpStill.handle());
    call.sets[i] = std::move(set);
  }
  return {};
}

Result<PointQuery> PointQuery::create(Device& device, const Waves& waves, const PointQueryInfo& info) {
  PELAGIC_CHECK(validate(info));
  auto impl = std::make_unique<Impl>();
  impl->context = &device.context();
  impl->waves = waves.impl_.get();
  impl->info = info;
  PELAGIC_TRY(sampler, gpu::createSampler(*impl->context, "query", {vk::Filter::eNearest}));
  impl->sampler = std::move(sampler);
  if (info.motion) {
    PELAGIC_TRY(motion, WaveMotion::create(*impl->context, impl->waves->transform, impl->waves->info.loopPeriod));
    impl->motion = std::move(motion);
  } else {
    PELAGIC_TRY(still, gpu::Buffer::create(*impl->context, Stage::waves, "query still", sizeof(glm::vec4),
                                           vk::BufferUsageFlagBits::eStorageBuffer));
    impl->still = std::move(still);
  }
  impl->warp.emplace(impl->waves->info.layout, impl->waves->info.warp);
  PELAGIC_TRY(warpStill, gpu::Buffer::create(*impl->context, Stage::waves, "query warp", sizeof(shader::WaveWarp),
                                             vk::BufferUsageFlagBits::eStorageBuffer, gpu::Buffer::Placement::upload));
  *static_cast<shader::WaveWarp*>(warpStill.mapped()) = impl->warp->relativeTo({0, 0});
  impl->warpStill = std::move(warpStill);
  PELAGIC_CHECK(impl->createPasses());
  impl->calls.resize(info.callsInFlight);
  for (std::uint32_t i = 0; i < info.callsInFlight; ++i) PELAGIC_CHECK(impl->createCall(impl->calls[i], i));
  return PointQuery(std::move(impl));
}

Result<PointQuery::Impl::Call*> PointQuery::Impl::begin(std::size_t count, const char* name, Kind kind) {
  if (count > info.capacity) {
    return gpu::reject(std::to_string(count) + " " + name + " are asked for, PointQueryInfo::capacity is " +
                       std::to_string(info.capacity));
  }
  if (waves->recordings == 0) return gpu::reject("points of the sea are asked for before Waves::record() was called");
  Call& call = calls[++newest % calls.size()];
  call.ticket = newest;
  call.kind = kind;
  call.origins.clear();
  call.exists.clear();
  return &call;
}

void PointQuery::Impl::start(Call& call, std::size_t item, std::size_t count, const glm::dvec2& place) const noexcept {
  const bool exists = onEarth(place);
  call.origins.push_back(place);
  call.exists.push_back(exists);
  const WaveLayout& layout = waves->info.layout;
  const glm::dvec2 from = warp->patchPlace(place);
  auto* turns = static_cast<Turns*>(call.starts.mapped()) + item;
  for (std::uint32_t c = 0; c < layout.count; ++c, turns += count) {
    const double length = layout.cascades[c].length;
    *turns = exists ? Turns(turnsOf(from.x, length), turnsOf(from.y, length)) : Turns(0);
  }
  *turns = exists ? glm::floatBitsToUint(glm::vec2((place - waves->gain.origin) / waves->gain.spacing)) : Turns(0);
  const shader::WaveWarp there = warp->relativeTo(exists ? place : glm::dvec2(0));
  for (const glm::vec4& phases : there.phase) {
    for (int i = 0; i < 4; i += 2) {
      turns += count;
      *turns = {std::bit_cast<std::uint32_t>(phases[i]), std::bit_cast<std::uint32_t>(phases[i + 1])};
    }
  }
}

void PointQuery::Impl::dispatch(vk::CommandBuffer commands, Call& call, std::size_t count) noexcept {
  if (count == 0) return;
  if (info.motion && movedTo != waves->recordings) {
    const Share share = waves->sea.share(waves->shown);
    motion.record(commands, loopFraction(waves->shown, waves->info.loopPeriod), share.value < 1, share);
    movedTo = waves->recordings;
  }
  const WaveLayout& layout = waves->info.layout;
  shader::QueryPush push{};
  for (std::uint32_t c = 0; c < layout.count; ++c) {
    push.turnsPerMetre[c / 4][static_cast<int>(c % 4)] = static_cast<float>(1 / layout.cascades[c].length);
  }
  push.count = static_cast<std::uint32_t>(count);
  push.halfCell = static_cast<float>(0.5 * layout.cascades[layout.count - 1].length / layout.size);
  push.gainSamplesPerMetre = static_cast<float>(1 / waves->gain.spacing);
  gpu::Barrier().buffer(call.results, gpu::kComputeWrite).record(*context, commands);
  const gpu::ComputePass& pass = call.kind == Kind::rays ? rayPass : pointPass;
  pass.bind(commands, call.sets[waves->newest]);
  pass.push(commands, push);
  pass.dispatch(commands, gpu::groups(push.count, shader::kQueryThreads));
  gpu::Barrier().buffer(call.results, gpu::kHostRead).record(*context, commands);
}

Result<std::uint64_t> PointQuery::record(VkCommandBuffer commands, std::span<const glm::dvec2> points) {
  PELAGIC_TRY(call, impl_->begin(points.size(), "points", Impl::Kind::points));
  for (std::size_t i = 0; i < points.size(); ++i) impl_->start(*call, i, points.size(), points[i]);
  impl_->dispatch(commands, *call, points.size());
  return call->ticket;
}

Result<std::uint64_t> PointQuery::recordRays(VkCommandBuffer commands, std::span<const SurfaceRay> rays) {
  PELAGIC_TRY(call, impl_->begin(rays.size(), "rays", Impl::Kind::rays));
  const SeaChange& sea = impl_->waves->sea;
  const double deviation = impl_->waves->largestGain *
                           std::max(elevationDeviation(sea.after.moments), elevationDeviation(sea.before.moments));
  auto* told = static_cast<shader::QueryRay*>(call->rays.mapped());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const SurfaceRay& ray = rays[i];
    const auto part = partAtSea(ray.origin, ray.direction, ray.reach, deviation);
    const glm::dvec3 start = part ? ray.origin + part->from * part->direction : glm::dvec3(std::nan(""));
    impl_->start(*call, i, rays.size(), {start.x, start.z});
    told[i] = {};
    told[i].reach = part ? static_cast<float>(part->to - part->from) : -1;
    if (!part) continue;
    told[i].direction = glm::vec4(glm::vec3(part->direction), 0);
    told[i].height = static_cast<float>(start.y);
  }
  impl_->dispatch(commands, *call, rays.size());
  return call->ticket;
}

Result<const PointQuery::Impl::Call*> PointQuery::Impl::find(std::uint64_t ticket, std::size_t count, Kind kind) const {
  const std::string name = "the ticket " + std::to_string(ticket);
  if (ticket == 0 || ticket > newest) return gpu::reject(name + " was never given");
  const Call& call = calls[ticket % calls.size()];
  if (call.ticket != ticket) {
    return gpu::reject(name + " is too old: " + std::to_string(newest - ticket) +
                       " more calls were recorded, PointQueryInfo::callsInFlight is " + std::to_string(calls.size()));
  }
  if (call.kind != kind) return gpu::reject(name + (kind == Kind::rays ? " is of points" : " is of rays"));
  if (count != call.origins.size()) {
    return gpu::reject(name + " has " + std::to_string(call.origins.size()) + " results, there is room for " +
                       std::to_string(count));
  }
  return &call;
}

SurfacePoint PointQuery::Impl::pointOf(const Call& call, std::size_t item) const noexcept {
  const auto& result = static_cast<const shader::QueryResult*>(call.results.mapped())[item];
  const glm::dvec2 place = call.origins[item] + glm::dvec2(result.point);
  SurfacePoint point;
  point.position = {place.x, static_cast<double>(result.normal.w), place.y};
  point.undisplaced = place + glm::dvec2(result.undisplaced);
  point.normal = glm::normalize(glm::dvec3(result.normal));
  point.velocity = glm::dvec3(result.velocity);
  point.acceleration = glm::dvec3(result.acceleration);
  return point;
}

Result<void> PointQuery::read(std::uint64_t ticket, std::span<SurfacePoint> results) const {
  PELAGIC_TRY(call, impl_->find(ticket, results.size(), Impl::Kind::points));
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (call->exists[i]) {
      results[i] = impl_->pointOf(*call, i);
    } else {
      results[i] = {};
      results[i].position = {call->origins[i].x, std::nan(""), call->origins[i].y};
    }
  }
  return {};
}

Result<void> PointQuery::readRays(std::uint64_t ticket, std::span<std::optional<SurfacePoint>> results) const {
  PELAGIC_TRY(call, impl_->find(ticket, results.size(), Impl::Kind::rays));
  const auto* told = static_cast<const shader::QueryResult*>(call->results.mapped());
  for (std::size_t i = 0; i < results.size(); ++i) {
    const bool met = call->exists[i] && told[i].velocity.w > 0;
    results[i] = met ? std::optional(impl_->pointOf(*call, i)) : std::nullopt;
  }
  return {};
}

}  // namespace pelagic
