#include <cmath>
#include <cstring>
#include <glm/gtc/constants.hpp>

#include "bench.hpp"
#include "vkfft.hpp"

namespace bench {

namespace {

/// A peer that computes nothing would be a fast one: the mode (3, 5) of the last transform must become its plane wave.
void check(Setup& setup, VkFft& fft, std::uint32_t transforms, std::uint32_t size) {
  const std::size_t samples = std::size_t{size} * size;
  const std::size_t base = (transforms - 1) * samples;
  const float one = 1;
  setup.gpu.run([&](vk::CommandBuffer commands) {
    commands.fillBuffer(fft.buffer(), 0, VK_WHOLE_SIZE, 0);
    const vk::MemoryBarrier2 order(vk::PipelineStageFlagBits2::eAllCommands, vk::AccessFlagBits2::eMemoryWrite,
                                   vk::PipelineStageFlagBits2::eAllCommands,
                                   vk::AccessFlagBits2::eMemoryRead | vk::AccessFlagBits2::eMemoryWrite);
    commands.pipelineBarrier2({{}, order});
    commands.updateBuffer(fft.buffer(), (base + 5 * size + 3) * 2 * sizeof(float), sizeof one, &one);
    commands.pipelineBarrier2({{}, order});
    fft.record(commands);
  });
  const auto bytes = common::readBuffer(setup.gpu, fft.buffer(), fft.bytes());
  std::vector<float> values(bytes.size() / sizeof(float));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  for (std::size_t i = 0; i < samples; ++i) {
    const double turns = static_cast<double>(3 * (i % size) + 5 * (i / size)) / size;
    const double expected = std::cos(2 * glm::pi<double>() * turns);
    if (!(std::abs(static_cast<double>(values[2 * (base + i)]) - expected) < 1e-4))
      fatal("VkFFT computes something else");
  }
  if (values[0] != 0) fatal("VkFFT mixes its transforms");
  setup.gpu.run([&](vk::CommandBuffer commands) { commands.fillBuffer(fft.buffer(), 0, VK_WHOLE_SIZE, 0); });
}

}  // namespace

void addVkFft(Setup& setup, Results& results) {
  for (const std::uint32_t size : {64u, 128u, 256u, 512u}) {
    const std::string name = "VkFFT/16x" + std::to_string(size);
    benchmark::RegisterBenchmark(name.c_str(),
                                 [&setup, &results, size, name](benchmark::State& state) {
                                   VkFft fft = require(VkFft::create(setup.gpu, 16, size));
                                   check(setup, fft, 16, size);
                                   measure(state, setup, results.start(name),
                                           [&](vk::CommandBuffer commands) { fft.record(commands); });
                                 })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace bench
