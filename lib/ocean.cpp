#include <pelagic/ocean.hpp>

#include <gpu/context.hpp>

namespace pelagic {

struct Ocean::Impl {
  Waves waves;
  Sky sky;
  Surface surface;
  Composite composite;
  WaterMedium medium;
};

struct OceanView::Impl {
  Ocean::Impl* ocean;
  SkyView sky;
  SurfaceView surface;
  CompositeView composite;
};

Ocean::Ocean(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
Ocean::Ocean(Ocean&&) noexcept = default;
Ocean& Ocean::operator=(Ocean&&) noexcept = default;
Ocean::~Ocean() = default;

OceanView::OceanView(std::unique_ptr<Impl> impl) noexcept : impl_(std::move(impl)) {}
OceanView::OceanView(OceanView&&) noexcept = default;
OceanView& OceanView::operator=(OceanView&&) noexcept = default;
OceanView::~OceanView() = default;

Result<Ocean> Ocean::create(Device& device, const OceanInfo& info) {
  PELAGIC_CHECK(validate(info.medium));
  PELAGIC_TRY(waves, Waves::create(device, info.waves));
  PELAGIC_TRY(sky, Sky::create(device, info.sky, info.surface.planetRadius, info.environment));
  PELAGIC_TRY(surface, Surface::create(device, info.surface));
  PELAGIC_TRY(composite, Composite::create(device));
  PELAGIC_CHECK(composite.setLights(info.lights));
  return Ocean(std::make_unique<Impl>(
      Impl{std::move(waves), std::move(sky), std::move(surface), std::move(composite), info.medium}));
}

Result<void> Ocean::setSea(const SeaState& sea, const SeaTransition& transition) {
  return impl_->waves.setSea(sea, transition);
}
Result<void> Ocean::setGain(const GainMap& map) { return impl_->waves.setGain(map); }

Result<void> Ocean::setSky(const SkyState& sky) { return impl_->sky.setState(sky); }

Result<void> Ocean::setEnvironment(const SkyEnvironment& environment) { return impl_->sky.setEnvironment(environment); }

Result<void> Ocean::setMedium(const WaterMedium& medium) {
  PELAGIC_CHECK(validate(medium));
  impl_->medium = medium;
  return {};
}

Result<void> Ocean::setLights(std::span<const HostLight> lights) { return impl_->composite.setLights(lights); }

Result<OceanView> Ocean::createView(const CompositeTargets& targets) {
  PELAGIC_TRY(surface, SurfaceView::create(impl_->surface, impl_->waves.maps(), targets.output.extent));
  PELAGIC_TRY(sky, SkyView::create(impl_->sky, targets.output.extent));
  PELAGIC_TRY(composite,
              CompositeView::create(impl_->composite, impl_->waves.maps(), sky.maps(), surface.buffer(), targets));
  return OceanView(std::make_unique<OceanView::Impl>(
      OceanView::Impl{impl_.get(), std::move(sky), std::move(surface), std::move(composite)}));
}

void Ocean::record(VkCommandBuffer commands, double time, Timings* timings) noexcept {
  impl_->waves.record(commands, time, timings);
  impl_->sky.record(commands, time, timings);
}

const Waves& Ocean::waves() const noexcept { return impl_->waves; }
const Sky& Ocean::sky() const noexcept { return impl_->sky; }

void OceanView::record(VkCommandBuffer commands, const Camera& camera, Timings* timings) noexcept {
  Ocean::Impl& ocean = *impl_->ocean;
  const WaveMaps maps = ocean.waves.maps();
  impl_->sky.record(commands, camera, timings);
  impl_->surface.record(commands, maps, camera, timings);
  impl_->composite.record(commands, maps, impl_->surface.buffer(), camera, ocean.medium, timings);
}

WaterBuffer OceanView::waterBuffer() const noexcept { return impl_->surface.buffer(); }
VkBuffer OceanView::drawArguments() const noexcept { return impl_->surface.drawArguments(); }

}  // namespace pelagic
