/// pelagic-bench [--device INDEX|NAME] [Google Benchmark's options]
#include <cstdio>
#include <cstring>

#include "bench.hpp"

namespace {

/// The reporter that was asked for, without the suffix "/manual_time" that says how a time was taken.
class PlainNames : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override { return inner_->ReportContext(context); }
  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> plain = runs;
    for (Run& run : plain) {
      run.run_name.time_type.clear();
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

/// Takes `--device X` or `--device=X` out of the arguments.
std::string takeDevice(int& argc, char** argv) {
  constexpr std::string_view kOption = "--device";
  std::string device;
  int kept = 1;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == kOption && i + 1 < argc) {
      device = argv[++i];
    } else if (argument.rfind(std::string(kOption) + "=", 0) == 0) {
      device = argument.substr(kOption.size() + 1);
    } else {
      argv[kept++] = argv[i];
    }
  }
  argc = kept;
  return device;
}

}  // namespace

int main(int argc, char** argv) {
  common::GpuDeviceOptions options;
  options.select = takeDevice(argc, argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;

  common::GpuDevice gpu = bench::require(common::GpuDevice::create(options));
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
