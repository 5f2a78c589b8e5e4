#include <algorithm>
#include <common/failure.hpp>
#include <common/scene.hpp>
#include <map>
#include <regex>

#include "bench.hpp"

namespace bench {

namespace {

constexpr vk::Extent2D kExtent{1280, 720};
constexpr vk::Extent2D kLargeExtent{1920, 1080};

std::string nameOf(std::string_view scene, vk::Extent2D extent) {
  return "Frame/" + std::string(scene) + "/" + std::to_string(extent.width) + "x" + std::to_string(extent.height);
}
constexpr int kPassFrames = 20;

/// A scene as pelagic-render draws it for the screen.
class Frame {
 public:
  Frame(Setup& setup, const std::string& scene, vk::Extent2D extent = kExtent) {
    common::loadScene("--scene", scene, scene_);
    time_ = scene_.time;
    camera_ = common::cameraOf(scene_.view, static_cast<double>(extent.width) / extent.height);
    using Usage = vk::ImageUsageFlagBits;
    hdr_ = common::createImage(setup.gpu, vk::Format::eR16G16B16A16Sfloat, extent, Usage::eStorage | Usage::eSampled,
                               "bench.hdr");
    screen_ = common::createImage(setup.gpu, vk::Format::eR8G8B8A8Unorm, extent, Usage::eStorage | Usage::eTransferSrc,
                                  "bench.screen");
    ocean_.emplace(require(pelagic::Ocean::create(setup.device, common::oceanInfo(scene_))));
    pelagic::CompositeTargets targets;
    targets.output = hdr_.host(common::kUndefined, pelagic::kShaderRead);
    view_.emplace(require(ocean_->createView(targets)));
    toneMap_.emplace(
        require(pelagic::ToneMap::create(setup.device, {hdr_.host(pelagic::kShaderRead, pelagic::kShaderRead),
                                                        screen_.host(common::kUndefined, common::kTransferSource)})));
  }

  void record(vk::CommandBuffer commands, pelagic::Timings* timings = nullptr) {
    ocean_->record(commands, time_, timings);
    view_->record(commands, camera_, timings);
    toneMap_->record(commands, static_cast<float>(scene_.exposure), timings);
    time_ += 1.0 / 60;
  }

 private:
  common::Scene scene_;
  double time_ = 0;
  pelagic::Camera camera_;
  common::OwnedImage hdr_;
  common::OwnedImage screen_;
  std::optional<pelagic::Ocean> ocean_;
  std::optional<pelagic::OceanView> view_;
  std::optional<pelagic::ToneMap> toneMap_;
};

/// Milliseconds of each pass of the default scene, kPassFrames of each; passes of one name add up.
using PassSamples = std::map<std::string, std::vector<double>>;

PassSamples samplePasses(Setup& setup) {
  Frame frame(setup, std::string(common::kDefaultScene));
  PassSamples samples;
  setup.gpu.run([&](vk::CommandBuffer commands) { frame.record(commands); });
  for (int i = 0; i < kPassFrames; ++i) {
    setup.gpu.run([&](vk::CommandBuffer commands) {
      setup.timings.reset(commands);
      frame.record(commands, &setup.timings);
    });
    for (const auto& pass : require(setup.timings.read())) {
      auto& values = samples[pass.name];
      values.resize(static_cast<std::size_t>(i) + 1);
      values.back() += pass.milliseconds;
    }
  }
  return samples;
}

}  // namespace

void addFrames(Setup& setup, Results& results) {
  const auto add = [&](std::string scene, vk::Extent2D extent) {
    const std::string name = nameOf(scene, extent);
    benchmark::RegisterBenchmark(name.c_str(),
                                 [&setup, &results, scene = std::move(scene), extent, name](benchmark::State& state) {
                                   Frame frame(setup, scene, extent);
                                   measure(state, setup, results.start(name),
                                           [&](vk::CommandBuffer commands) { frame.record(commands); });
                                 })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  };
  for (const common::BuiltinScene& scene : common::builtinScenes()) add(std::string(scene.name), kExtent);
  add(std::string(common::kDefaultScene), kLargeExtent);
}

void addPasses(Setup& setup, Results& results) {
  for (const auto& [pass, samples] : samplePasses(setup)) {
    const std::string name = "Pass/" + pass + "/1280x720";
    benchmark::RegisterBenchmark(name.c_str(),
                                 [&results, samples = samples, name](benchmark::State& state) {
                                   std::size_t i = 0;
                                   for (auto _ : state) state.SetIterationTime(samples[i++ % samples.size()] * 1e-3);
                                   results.start(name) = samples;
                                   state.counters["median_ms"] = median(samples);
                                 })
        ->UseManualTime()
        ->Iterations(kPassFrames)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace bench
