#include "bench.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace bench {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<double>& Results::start(const std::string& name) {
  const auto found =
      std::find_if(samples_.begin(), samples_.end(), [&](const auto& entry) { return entry.first == name; });
  if (found == samples_.end()) return samples_.emplace_back(name, std::vector<double>()).second;
  return found->second;
}

void Results::printRatios() const {
  const auto find = [&](const std::string& name) {
    const auto found =
        std::find_if(samples_.begin(), samples_.end(), [&](const auto& entry) { return entry.first == name; });
    return found == samples_.end() || found->second.empty() ? nullptr : &found->second;
  };
  for (const auto& [name, values] : samples_) {
    const bool step = name.rfind("WaveStep/4x", 0) == 0;
    const std::string reference = step ? "VkFFT/16x" + name.substr(11) : "VkFFT/16x256";
    const std::vector<double>* peer = find(reference);
    if (!peer || values.empty() || !(step || name.rfind("Frame/", 0) == 0)) continue;
    const double least = *std::min_element(values.begin(), values.end());
    const double leastPeer = *std::min_element(peer->begin(), peer->end());
    std::fprintf(stderr, "%s / %s: median %.2f, minimum %.2f\n", name.c_str(), reference.c_str(),
                 median(values) / median(*peer), least / leastPeer);
  }
}

void measure(benchmark::State& state, Setup& setup, std::vector<double>& samples,
             const std::function<void(vk::CommandBuffer)>& record,
             const std::function<void(vk::CommandBuffer)>& before) {
  constexpr double kBusy = 20;  // [ms]
  const auto run = [&](std::size_t repeats) {
    setup.gpu.run([&](vk::CommandBuffer commands) {
      setup.timings.reset(commands);
      for (std::size_t i = 0; i < repeats; ++i) {
        if (before) before(commands);
        setup.timings.begin(commands, "measured");
        record(commands);
        setup.timings.end(commands);
        const vk::AccessFlags2 written = vk::AccessFlagBits2::eShaderStorageWrite;
        const vk::MemoryBarrier2 order(vk::PipelineStageFlagBits2::eComputeShader, written,
                                       vk::PipelineStageFlagBits2::eComputeShader,
                                       written | vk::AccessFlagBits2::eShaderStorageRead);
        commands.pipelineBarrier2({{}, order});
      }
    });
    return require(setup.timings.read());
  };
  run(1);
  const double once = run(1).front().milliseconds;
  const auto repeats = static_cast<std::size_t>(std::clamp(kBusy / once, 1.0, double{pelagic::Timings::kMaxPasses}));
  // Until a GPU has raised its clock.
  constexpr std::chrono::milliseconds kWarmUp(300);
  for (const auto start = std::chrono::steady_clock::now(); std::chrono::steady_clock::now() - start < kWarmUp;) {
    run(repeats);
  }
  for (auto _ : state) {
    double sum = 0;
    for (const pelagic::Timings::Pass& pass : run(repeats)) {
      samples.push_back(pass.milliseconds);
      sum += pass.milliseconds;
    }
    state.SetIterationTime(sum / static_cast<double>(repeats) * 1e-3);
  }
  state.counters["median_ms"] = median(samples);
}

void fatal(const std::string& message) {
  std::fprintf(stderr, "pelagic-bench: %s\n", message.c_str());
  std::exit(4);
}

}  // namespace bench
