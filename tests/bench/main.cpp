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

/// Pelagic's own options; Google Benchmark's stay in argv.
struct Options {
  common::GpuDeviceOptions gpu;
  bool version = false;
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
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;

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
