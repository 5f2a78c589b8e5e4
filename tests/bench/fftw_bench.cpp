#include <fftw3.h>

#include <chrono>

#include "bench.hpp"

namespace bench {

namespace {

void run(benchmark::State& state, int size, std::vector<double>& samples) {
  constexpr int kTransforms = 16;
  constexpr int kThreads = 2;
  const int sizes[] = {size, size};
  const int distance = size * size;
  fftwf_plan_with_nthreads(kThreads);
  fftwf_complex* data = fftwf_alloc_complex(static_cast<std::size_t>(kTransforms * distance));
  const fftwf_plan plan = fftwf_plan_many_dft(2, sizes, kTransforms, data, nullptr, 1, distance, data, nullptr, 1,
                                              distance, FFTW_BACKWARD, FFTW_MEASURE);
  std::fill_n(&data[0][0], 2 * kTransforms * distance, 0.0f);
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    fftwf_execute(plan);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    samples.push_back(seconds.count() * 1e3);
    state.SetIterationTime(seconds.count());
  }
  fftwf_destroy_plan(plan);
  fftwf_free(data);
}

}  // namespace

void addFftw(Results& results) {
  fftwf_init_threads();
  for (const int size : {64, 128, 256, 512}) {
    const std::string name = "FFTW/16x" + std::to_string(size);
    benchmark::RegisterBenchmark(
        name.c_str(), [&results, size, name](benchmark::State& state) { run(state, size, results.start(name)); })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace bench
