#include <pelagic/waves.hpp>

#include "bench.hpp"

namespace bench {

/// The whole wave stage of a frame: spectrum in time, transforms, all maps, foam and mips, as the sea moves on.
void addWaveSteps(Setup& setup, Results& results) {
  for (const std::uint32_t size : {128u, 256u, 512u}) {
    const std::string name = "WaveStep/4x" + std::to_string(size);
    benchmark::RegisterBenchmark(name.c_str(),
                                 [&setup, &results, size, name](benchmark::State& state) {
                                   pelagic::WavesInfo info;
                                   info.layout = require(pelagic::waveLayout(info.sea, 4, size));
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
