#include <algorithm>
#include <cmath>
#include <waves/gain_field.hpp>
#include <waves/trochoids.hpp>
#include <waves/waves_impl.hpp>

namespace pelagic {
namespace {

constexpr ImageState kImageClear{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};

void begin(Timings* timings, VkCommandBuffer commands, const char* name) noexcept {
  if (timings) timings->begin(commands, name);
}
void end(Timings* timings, VkCommandBuffer commands) noexcept {
  if (timings) timings->end(commands);
}

}  // namespace

Waves::Waves(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
Waves::Waves(Waves&&) noexcept = default;
Waves& Waves::operator=(Waves&&) noexcept = default;
Waves::~Waves() = default;

Result<Waves> Waves::create(Device& device, const WavesInfo& info) {
  PELAGIC_CHECK(validate(info));
  auto impl = std::make_unique<Impl>();
  impl->context = &device.context();
  impl->info = info;
  impl->sea.after = makeGridSea(info.sea, info);
  PELAGIC_TRY(images, createWaveImages(*impl->context, info));
  impl->images = std::move(images);
  PELAGIC_TRY(gainImage, GainImage::create(*impl->context, info));
  impl->gainImage = std::move(gainImage);
  impl->gain = std::move(impl->info.gain);
  PELAGIC_TRY(transform, WaveTransform::create(*impl->context, info, impl->images));
  impl->transform = std::move(transform);
  PELAGIC_TRY(filter, WaveFilter::create(*impl->context, info, impl->images));
  impl->filter = std::move(filter);
  return Waves(std::move(impl));
}

Result<void> Waves::setSea(const SeaState& sea, const SeaTransition& transition) {
  PELAGIC_CHECK(validate(sea));
  PELAGIC_CHECK(validate(sea, impl_->info.layout));
  PELAGIC_CHECK(validate(transition));
  impl_->wanted = changeSea(impl_->latest(), makeGridSea(sea, impl_->info), transition, impl_->info);
  return {};
}

Result<void> Waves::setGain(const GainMap& map) {
  PELAGIC_CHECK(validate(map, impl_->info.layout.count));
  const GainMap& present = impl_->gain;
  if (map.width != present.width || map.height != present.height) {
    const auto size = [](const GainMap& of) { return std::to_string(of.width) + " x " + std::to_string(of.height); };
    return gpu::reject("GainMap has " + size(map) + " samples, it must have " + size(present) +
                       " as the one that the simulation was created with");
  }
  impl_->newGain = map;
  return {};
}

void Waves::Impl::recordUpload(vk::CommandBuffer commands) noexcept {
  if (newGain) {
    std::swap(gain, *newGain);
    newGain.reset();
    gainUploaded = false;
  }
  if (!gainUploaded) {
    gainImage.upload(commands, gain, slot);
    largestGain = pelagic::largestGain(gain);
    gainUploaded = true;
  }
  if (wanted) {
    std::swap(sea, *wanted);
    wanted.reset();
    uploaded = false;
  }
  if (!uploaded) {
    transform.upload(commands, sea, slot);
    // The foam of a sea is a function of the sea and the time alone: that of another sea is not carried over.
    hasFoam = false;
    uploaded = true;
  }
  slot = (slot + 1) % info.framesInFlight;
}

double Waves::Impl::foamClock(double time) const noexcept {
  const double rest = std::fmod(time, info.loopPeriod);  // exact
  return (rest < 0 ? rest + info.loopPeriod : rest) / foamTickLength();
}

void Waves::Impl::recordFoam(vk::CommandBuffer commands, double time) noexcept {
  const double now = std::floor(foamClock(time));
  const double loopStart = time - foamClock(time) * foamTickLength();
  // A tick older than kFoamSteps has faded away, so a replay of kFoamSteps ticks is complete from any start.
  const bool replay = !hasFoam || now < foamTick || now - foamTick >= shader::kFoamSteps;
  const std::uint32_t ticks = replay ? shader::kFoamSteps : static_cast<std::uint32_t>(now - foamTick);
  for (std::uint32_t left = ticks; left-- > 0;) {
    const bool keep = !replay || left + 1 < ticks;
    const double tick = (now - left) * foamTickLength();  // since the loop began, exact
    SeaMoment moment = momentOf(loopStart + tick);
    moment.fraction = loopFraction(tick, info.loopPeriod);
    transform.recordFoamTick(commands, moment, keep);
  }
  foamTick = now;
  hasFoam = true;
}

void Waves::Impl::clearFoam(vk::CommandBuffer commands) noexcept {
  gpu::Barrier().image(images.foam, kImageClear, true).record(*context, commands);
  commands.clearColorImage(images.foam.handle(), vk::ImageLayout::eTransferDstOptimal, vk::ClearColorValue(),
                           images.foam.range(), context->dispatch);
}

void Waves::Impl::recordMaps(vk::CommandBuffer commands, double time, Timings* timings) noexcept {
  begin(timings, commands, "waves evolve rows");
  transform.recordRows(commands, momentOf(time));
  end(timings, commands);

  gpu::Image& displacement = images.displacement[newest];
  gpu::Barrier()
      .image(displacement, gpu::kComputeStorageWrite, true)
      .image(images.gradient, gpu::kComputeStorageWrite, true)
      .image(images.moments, gpu::kComputeStorageWrite, true)
      .image(images.foam, gpu::kComputeStorageWrite)
      .record(*context, commands);
  begin(timings, commands, "waves columns");
  transform.recordColumns(commands, momentOf(time), newest,
                          static_cast<float>((foamClock(time) - foamTick) / shader::kFoamSteps));
  end(timings, commands);
  begin(timings, commands, "waves filter");
  filter.record(commands, images, newest);
  end(timings, commands);
  gpu::Barrier()
      .image(displacement, kShaderRead)
      .image(images.gradient, kShaderRead)
      .image(images.moments, kShaderRead)
      .image(images.foam, kShaderRead)
      .record(*context, commands);
}

void Waves::record(VkCommandBuffer handle, double time, Timings* timings) noexcept {
  const vk::CommandBuffer commands(handle);
  impl_->recordUpload(commands);
  begin(timings, commands, "waves foam");
  impl_->recordFoam(commands, time);
  end(timings, commands);
  if (impl_->recordings++ == 0) {
    impl_->clearFoam(commands);  // the short cascades' layers stay so
    // Nothing moved before the first frame: both displacement maps show it.
    impl_->recordMaps(commands, time, nullptr);
  }
  impl_->shown = time;
  impl_->newest = 1 - impl_->newest;
  impl_->recordMaps(commands, time, timings);
}

WaveMaps Waves::maps() const noexcept {
  WaveMaps maps;
  const WaveImages& images = impl_->images;
  maps.displacement = images.displacement[impl_->newest].map();
  maps.previousDisplacement = images.displacement[1 - impl_->newest].map();
  maps.displacementPair = {images.displacement[0].map(), images.displacement[1].map()};
  maps.gradient = images.gradient.map();
  maps.moments = images.moments.map();
  maps.foam = images.foam.map();
  maps.gain = impl_->gainImage.map();
  maps.gainOrigin = impl_->gain.origin;
  maps.gainSpacing = impl_->gain.spacing;
  maps.layout = impl_->info.layout;
  maps.warp = impl_->info.warp;
  const double share = impl_->sea.share(impl_->shown).value;
  const SeaMoments moments = impl_->sea.momentsAt(share);
  maps.windDirection = impl_->sea.windDirectionAt(share);
  maps.windSpeed = impl_->sea.windSpeedAt(share);
  maps.unresolved = impl_->sea.unresolvedAt(share);
  maps.slopeCovariance = moments.slopes;
  maps.interpolationLoss = moments.interpolationLoss;
  maps.resolvedShare = moments.resolvedShare;
  maps.elevationDeviation = impl_->largestGain * elevationDeviation(moments);
  maps.horizontalDeviation = impl_->largestGain * horizontalDeviation(moments);
  maps.foamDecline = impl_->sea.foamDeclineAt(share);
  maps.choppiness = impl_->sea.choppinessAt(share);
  return maps;
}

SeaReport Waves::report() const noexcept { return impl_->latest().after.report; }

std::vector<Trochoid> Waves::trochoids() const {
  std::vector<Trochoid> waves;
  for (const GridTrochoid& placed :
       trochoidsOnGrid(impl_->latest().after.sea, impl_->info.layout, impl_->info.warp).waves) {
    waves.push_back(placed.wave);
  }
  return waves;
}

std::vector<double> Waves::modeVariance(std::uint32_t cascade) const {
  return makeModes(impl_->latest().after.sea, impl_->info.layout, cascade, impl_->info.loopPeriod).variance;
}

}  // namespace pelagic
