#include <chrono>
#include <pelagic/point_query.hpp>
#include <random>

#include "bench.hpp"

namespace bench {

namespace {

constexpr std::size_t kPoints = 10000;
constexpr double kShortest = 1;  // [m]

std::vector<glm::dvec2> randomPoints() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-1e3, 1e3);
  std::vector<glm::dvec2> points(kPoints);
  for (glm::dvec2& point : points) point = {place(random), place(random)};
  return points;
}

/// `move`: every iteration is at a new time, for which the sea is transformed first.
void run(benchmark::State& state, bool move, std::vector<double>& samples) {
  pelagic::WavesInfo info;
  info.layout = require(pelagic::waveLayout(info.sea));
  pelagic::SeaQuery query = require(pelagic::SeaQuery::create(info, kShortest));
  const std::vector<glm::dvec2> points = randomPoints();
  std::vector<double> heights(points.size());
  double time = 0;
  double sum = 0;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    if (move) query.setTime(time += 1.0 / 60);
    query.heightsAt(points, heights);
    sum += heights[0];
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    samples.push_back(seconds.count() * 1e3);
    state.SetIterationTime(seconds.count());
  }
  benchmark::DoNotOptimize(sum);
}

}  // namespace

/// GPU time of the question alone, after a step of the waves to a new time.
void runGpu(benchmark::State& state, Setup& setup, bool motion, std::vector<double>& samples) {
  pelagic::WavesInfo info;
  info.layout = require(pelagic::waveLayout(info.sea));
  pelagic::Waves waves = require(pelagic::Waves::create(setup.device, info));
  pelagic::PointQuery query = require(pelagic::PointQuery::create(setup.device, waves, {kPoints, 1, motion}));
  const std::vector<glm::dvec2> points = randomPoints();
  double time = 0;
  const auto step = [&](vk::CommandBuffer commands) { waves.record(commands, time += 1.0 / 60); };
  measure(
      state, setup, samples, [&](vk::CommandBuffer commands) { require(query.record(commands, points)); }, step);
}

/// Heights on one core, of waves of a metre and more; and surface points on the GPU after a step of the waves, with and
/// without their motion.
void addQueries(Setup& setup, Results& results) {
  for (const bool move : {false, true}) {
    const std::string name = "Query/cpu/" + std::to_string(kPoints) + (move ? "/new-time" : "");
    benchmark::RegisterBenchmark(
        name.c_str(), [&results, move, name](benchmark::State& state) { run(state, move, results.start(name)); })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
  for (const bool motion : {true, false}) {
    const std::string name = "Query/gpu/" + std::to_string(kPoints) + (motion ? "" : "/heights");
    benchmark::RegisterBenchmark(name.c_str(),
                                 [&setup, &results, motion, name](benchmark::State& state) {
                                   runGpu(state, setup, motion, results.start(name));
                                 })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace bench
