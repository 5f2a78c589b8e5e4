/// What all benchmarks share: one device, and GPU times from timestamps.
#pragma once

#include <benchmark/benchmark.h>

#include <common/gpu_device.hpp>
#include <functional>
#include <pelagic/timings.hpp>
#include <string>
#include <vector>

namespace bench {

/// The device of the run and Pelagic on it.
struct Setup {
  common::GpuDevice gpu;
  pelagic::Device device;
  pelagic::Timings timings;
};

/// Milliseconds of every measured iteration, by benchmark name: all of them, repetitions too.
class Results {
 public:
  std::vector<double>& start(const std::string& name);
  /// Prints the ratios that Pelagic is judged by, of what was measured.
  void printRatios() const;

 private:
  std::vector<std::pair<std::string, std::vector<double>>> samples_;
};

/// Measures the GPU time of what `record` records. Each iteration is a command buffer of its own, waited for, that
/// repeats it until there is work for some time: a GPU that idles between short submissions lowers its clock, an H200
/// to a sixth. One unmeasured run comes first: a software device compiles its shaders then. `before`, if any, is
/// recorded in front of each, unmeasured.
void measure(benchmark::State& state, Setup& setup, std::vector<double>& samples,
             const std::function<void(vk::CommandBuffer)>& record,
             const std::function<void(vk::CommandBuffer)>& before = nullptr);

/// The value or, with the error on stderr, the end of the program.
template <class T, class E>
T require(tl::expected<T, E>&& result);
[[noreturn]] void fatal(const std::string& message);

inline const std::string& messageOf(const std::string& error) { return error; }
inline const std::string& messageOf(const pelagic::Error& error) { return error.message; }
inline const std::string& messageOf(const common::GpuDeviceError& error) { return error.message; }

template <class T, class E>
T require(tl::expected<T, E>&& result) {
  if (!result) fatal(messageOf(result.error()));
  return std::move(*result);
}

double median(std::vector<double> values);

void addFrames(Setup& setup, Results& results);
/// Draws the default scene to learn its passes.
void addPasses(Setup& setup, Results& results);
void addWaveSteps(Setup& setup, Results& results);
void addVkFft(Setup& setup, Results& results);
void addFftw(Results& results);
void addQueries(Setup& setup, Results& results);

}  // namespace bench
