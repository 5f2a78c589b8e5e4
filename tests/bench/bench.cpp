#include "bench.hpp"

#include <algorithm>
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
  setup.gpu.run([&](vk::CommandBuffer commands) {
    if (before) before(commands);
    record(commands);
  });
  for (auto _ : state) {
    setup.gpu.run([&](vk::CommandBuffer commands) {
      if (before) before(commands);
      setup.timings.reset(commands);
      setup.timings.begin(commands, "measured");
      record(commands);
      setup.timings.end(commands);
    });
    const double milliseconds = require(setup.timings.read()).front().milliseconds;
    samples.push_back(milliseconds);
    state.SetIterationTime(milliseconds * 1e-3);
  }
  state.counters["median_ms"] = median(samples);
}

void fatal(const std::string& message) {
  std::fprintf(stderr, "pelagic-bench: %s\n", message.c_str());
  std::exit(4);
}

}  // namespace bench
