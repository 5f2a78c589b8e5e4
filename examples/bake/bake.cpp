/// pelagic-bake: writes the maps of a sea as OpenEXR files, for whoever wants the sea as data.
#include <fmt/format.h>

#include <common/failure.hpp>
#include <common/image_file.hpp>
#include <common/program.hpp>
#include <common/progress.hpp>
#include <common/sea_json.hpp>
#include <common/sea_options.hpp>
#include <common/sequence.hpp>
#include <nlohmann/json.hpp>
#include <vulkan/vulkan.hpp>

#include "cascade_file.hpp"

namespace {

struct Options {
  common::SeaSettings sea;
  common::Sequence sequence;
  std::string output;
  bool variance = false;
};

void bakeSea(common::Program& program, const Options& options, common::OutputSet& outputs) {
  const std::filesystem::path directory = options.output;
  outputs.addDirectory("--output", directory);
  const auto file = [&](const std::string& name) { return outputs.add("--output", directory / name); };
  const auto document = file("sea.json");

  const common::GpuDevice gpu = program.openDevice();
  pelagic::Device device = common::unwrap(pelagic::Device::create(gpu.info()));
  pelagic::Waves waves =
      common::unwrap(pelagic::Waves::create(device, common::wavesInfo(options.sea, pelagic::MapPrecision::single)));

  const std::vector<double> times = options.sequence.times();
  common::Progress progress(static_cast<std::uint32_t>(times.size()));
  for (std::size_t frame = 0; frame < times.size(); ++frame) {
    gpu.run([&](vk::CommandBuffer commands) { waves.record(commands, times[frame]); });
    const pelagic::WaveMaps maps = waves.maps();
    for (std::uint32_t cascade = 0; cascade < maps.layout.count; ++cascade) {
      bake::writeCascade(gpu, maps, cascade, file(fmt::format("c{}.{:04}.exr", cascade, frame)));
    }
    progress.step();
  }
  const pelagic::WaveLayout layout = waves.maps().layout;
  for (std::uint32_t cascade = 0; options.variance && cascade < layout.count; ++cascade) {
    bake::writeVariance(waves, cascade, file(fmt::format("variance.c{}.exr", cascade)));
  }
  common::writeText(document, common::seaJson(options.sea, layout, waves.report(), times).dump(2) + "\n");
}

}  // namespace

int main(int argc, char** argv) {
  common::Program program("pelagic-bake",
                          "Writes the sea as data: one OpenEXR file per cascade and frame, and sea.json.");
  Options options;
  const common::Fields sea = common::seaFields(options.sea);
  program.addFile("--sea", "Options of the sea from a file; its keys are their names, options override it", sea, "Sea");
  program.add(sea, "Sea");
  program.add(common::sequenceFields(options.sequence, false), "Time");
  program.app().add_option("--output", options.output, "Directory for the files")->type_name("DIR")->group("Output");
  program.app()
      .add_flag("--variance", options.variance, "Also write the expected variance of every mode")
      ->group("Output");
  return program.run(argc, argv, [&](common::OutputSet& outputs) {
    common::checkSequence(program, false);
    if (options.output.empty()) common::refuse("--output", "", "a directory, it must be given");
    bakeSea(program, options, outputs);
  });
}
