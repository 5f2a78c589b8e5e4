#include <array>
#include <gpu/context.hpp>
#include <pelagic/timings.hpp>

namespace pelagic {

struct Timings::Impl {
  gpu::Context* context = nullptr;
  gpu::Unique<vk::QueryPool> pool;
  std::array<Pass, kMaxPasses> passes{};
  std::uint32_t count = 0;
  bool open = false;
};

Timings::Timings(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
Timings::Timings(Timings&&) noexcept = default;
Timings& Timings::operator=(Timings&&) noexcept = default;
Timings::~Timings() = default;

Result<Timings> Timings::create(Device& device) {
  auto impl = std::make_unique<Impl>();
  impl->context = &device.context();
  auto pool = impl->context->device.createQueryPoolUnique(
      vk::QueryPoolCreateInfo({}, vk::QueryType::eTimestamp, 2 * kMaxPasses), impl->context->allocator(),
      impl->context->dispatch);
  if (pool.result != vk::Result::eSuccess) return gpu::fail(pool.result, "create the timestamp query pool");
  impl->pool = std::move(pool.value);
  impl->context->name(*impl->pool, "pelagic timings");
  return Timings(std::move(impl));
}

void Timings::reset(VkCommandBuffer commands) noexcept {
  vk::CommandBuffer(commands).resetQueryPool(*impl_->pool, 0, 2 * kMaxPasses, impl_->context->dispatch);
  impl_->count = 0;
  impl_->open = false;
}

void Timings::begin(VkCommandBuffer commands, const char* name) noexcept {
  if (impl_->count == kMaxPasses) return;
  impl_->passes[impl_->count].name = name;
  vk::CommandBuffer(commands).writeTimestamp2(vk::PipelineStageFlagBits2::eBottomOfPipe, *impl_->pool, 2 * impl_->count,
                                              impl_->context->dispatch);
  // A software device may write the timestamp only when it next waits; without this it would do so at the pass's end.
  constexpr auto kStages = vk::PipelineStageFlagBits2::eComputeShader | vk::PipelineStageFlagBits2::eFragmentShader;
  const vk::MemoryBarrier2 execution(kStages, {}, kStages, {});
  vk::CommandBuffer(commands).pipelineBarrier2(vk::DependencyInfo({}, 1, &execution), impl_->context->dispatch);
  impl_->open = true;
}

void Timings::end(VkCommandBuffer commands) noexcept {
  if (!impl_->open) return;
  vk::CommandBuffer(commands).writeTimestamp2(vk::PipelineStageFlagBits2::eBottomOfPipe, *impl_->pool,
                                              2 * impl_->count + 1, impl_->context->dispatch);
  ++impl_->count;
  impl_->open = false;
}

Result<std::span<const Timings::Pass>> Timings::read() {
  if (impl_->count == 0) return std::span<const Pass>{};
  std::array<std::uint64_t, 2 * kMaxPasses> ticks{};
  const auto result = impl_->context->device.getQueryPoolResults(
      *impl_->pool, 0, 2 * impl_->count, sizeof(std::uint64_t) * 2 * impl_->count, ticks.data(), sizeof(std::uint64_t),
      vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait, impl_->context->dispatch);
  if (result != vk::Result::eSuccess) return gpu::fail(result, "read the timestamps");
  const double period = impl_->context->properties.limits.timestampPeriod;  // ns per tick
  for (std::uint32_t i = 0; i < impl_->count; ++i) {
    impl_->passes[i].milliseconds =
        static_cast<double>((ticks[2 * i + 1] - ticks[2 * i]) & impl_->context->timestampMask) * period * 1e-6;
  }
  return std::span<const Pass>(impl_->passes.data(), impl_->count);
}

}  // namespace pelagic
