#include <pelagic/waves.hpp>

#include "bench.hpp"

namespace bench {

/// The whole wave stage of a frame: spectrum in time, transforms, all maps, foam and mips, as the sea moves on.
void addWaveSteps(Setup& setup, Results& results) {
  struct Step {
    std::uint32_t cascades, size;
  };
  // By size with the default cascades, and by cascades with the default size: cost is linear in cascades and goes as
  // N^2 log N.
  constexpr Step kSteps[] = {{4, 128}, {1, 256}, {2, 256}, {4, 256}, {8, 256}, {4, 512}, {1, 1024}};
  for (const Step step : kSteps) {
    const std::string name = "WaveStep/" + std::to_string(step.cascades) + "x" + std::to_string(step.size);
    benchmark::RegisterBenchmark(name.c_str(),
                                 [&setup, &results, step, name](benchmark::State& state) {
                                   pelagic::WavesInfo info;
                                   info.layout = require(pelagic::waveLayout(info.sea, step.cascades, step.size));
                                   pelagic::Waves waves = require(pelagic::Waves::create(setup.device, info));
                                   constexpr double kFrame = 1.0 / 60;  // [s]
                                   double time = 0;
                                   measure(state, setup, results.start(name), [&](vk::CommandBuffer commands) {
                                     waves.record(commands, time);
                                     time += kFrame;
                                   });
                                 })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace bench
