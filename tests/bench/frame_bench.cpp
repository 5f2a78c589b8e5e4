#include <algorithm>
#include <common/failure.hpp>
#include <common/scene.hpp>
#include <map>
#include <regex>

#include "bench.hpp"

namespace bench {

namespace {

constexpr vk::Extent2D kExtent{1280, 720};
constexpr int kPassFrames = 20;

/// A scene as pelagic-render draws it for the screen.
class Frame {
 public:
  Frame(Setup& setup, const std::string& scene) {
    common::loadScene("--scene", scene, scene_);
    time_ = scene_.time;
    camera_ = common::cameraOf(scene_.view, double{kExtent.width} / kExtent.height);
    using Usage = vk::ImageUsageFlagBits;
    hdr_ = common::createImage(setup.gpu, vk::Format::eR16G16B16A16Sfloat, kExtent, Usage::eStorage | Usage::eSampled,
                               "bench.hdr");
    screen_ = common::createImage(setup.gpu, vk::Format::eR8G8B8A8Unorm, kExtent, Usage::eStorage | Usage::eTransferSrc,
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
  for (const common::BuiltinScene& scene : common::builtinScenes()) {
    const std::string name = "Frame/" + std::string(scene.name) + "/1280x720";
    benchmark::RegisterBenchmark(name.c_str(),
                                 [&setup, &results, scene, name](benchmark::State& state) {
                                   Frame frame(setup, std::string(scene.name));
                                   measure(state, setup, results.start(name),
                                           [&](vk::CommandBuffer commands) { frame.record(commands); });
                                 })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
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
