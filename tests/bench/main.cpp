/// pelagic-bench [--device INDEX|NAME] [--validate] [--version] [Google Benchmark's options]
#include <cstdio>
#include <cstring>

#include "bench.hpp"

namespace {

/// The reporter that was asked for, without the suffixes that say how a time was taken.
class PlainNames : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override { return inner_->ReportContext(context); }
  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> plain = runs;
    for (Run& run : plain) {
      run.run_name.time_type.clear();
      run.run_name.iterations.clear();
      failed_ = failed_ || run.error_occurred;
    }
    inner_->ReportRuns(plain);
  }
  void Finalize() override { inner_->Finalize(); }
  bool failed() const { return failed_; }

 private:
  std::unique_ptr<benchmark::BenchmarkReporter> inner_{benchmark::CreateDefaultDisplayReporter()};
  bool failed_ = false;
};

constexpr const char* kHelp =
    R"(Measures Pelagic and its peers on one device in one run; the last lines are ratios to VkFFT.
Usage: pelagic-bench [OPTIONS]
  --help                      Print this and leave
  --version                   Print the version and leave
  --device INDEX|NAME         Vulkan device; default: the best, a software device when there is no other
  --validate                  Validation layer on; exit 3 if it says anything
  --benchmark_filter=REGEX    Which: WaveStep/<cascades>x<size>, VkFFT/<transforms>x<size>, FFTW/<transforms>x<size>,
                              Frame/<scene>/<WxH>, Pass/<name>/<WxH>, Query/cpu/<points>[/new-time]
  --benchmark_list_tests      Print their names and leave
  --benchmark_repetitions=N --benchmark_min_time=SECONDS --benchmark_enable_random_interleaving=BOOL
  --benchmark_format=console|json|csv --benchmark_out=FILE --benchmark_out_format=console|json|csv
                              As Google Benchmark documents them)";

/// Pelagic's own options; Google Benchmark's stay in argv.
struct Options {
  common::GpuDeviceOptions gpu;
  bool version = false;
  bool help = false;
};

Options takeOptions(int& argc, char** argv) {
  constexpr std::string_view kDevice = "--device=";
  Options options;
  int kept = 1;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--device" && i + 1 < argc) {
      options.gpu.select = argv[++i];
    } else if (argument.starts_with(kDevice)) {
      options.gpu.select = argument.substr(kDevice.size());
    } else if (argument == "--validate") {
      options.gpu.validate = true;
    } else if (argument == "--version") {
      options.version = true;
    } else if (argument == "--help") {
      options.help = true;
    } else {
      argv[kept++] = argv[i];
    }
  }
  argc = kept;
  return options;
}

/// Runs what the filter selects. Returns the exit status but for validation.
int run(common::GpuDevice gpu) {
  pelagic::Device device = bench::require(pelagic::Device::create(gpu.info()));
  pelagic::Timings timings = bench::require(pelagic::Timings::create(device));
  bench::Setup setup{std::move(gpu), std::move(device), std::move(timings)};
  std::fprintf(stderr, "device: %s\n", setup.gpu.name().c_str());

  bench::Results results;
  bench::addWaveSteps(setup, results);
  bench::addVkFft(setup, results);
  bench::addFftw(results);
  bench::addQueries(setup, results);
  bench::addFrames(setup, results);
  const std::string filter = benchmark::GetBenchmarkFilter();
  if (filter.empty() || filter == "all" || filter.find("Pass") != std::string::npos) bench::addPasses(setup, results);
  PlainNames reporter;
  const std::size_t count = benchmark::RunSpecifiedBenchmarks(&reporter);
  results.printRatios();
  if (count == 0) return 2;
  return reporter.failed() ? 4 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = takeOptions(argc, argv);
  if (options.version) {
    std::puts("pelagic-bench " PELAGIC_VERSION);
    return 0;
  }
  if (options.help) {
    std::puts(kHelp);
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  if (argc > 1) {
    std::fprintf(stderr, "pelagic-bench: %s is unknown, allowed: what --help lists\n", argv[1]);
    return 2;
  }

  auto gpu = common::GpuDevice::create(options.gpu);
  if (!gpu) {
    std::fprintf(stderr, "pelagic-bench: %s\n", gpu.error().message.c_str());
    return gpu.error().noMatch ? 2 : 4;
  }
  // Outlives the device, whose destruction may have something to say too.
  const auto log = gpu->log();
  const int status = run(std::move(*gpu));
  for (const std::string& message : log->messages) std::fprintf(stderr, "%s\n", message.c_str());
  return status == 0 && !log->messages.empty() ? 3 : status;
}
