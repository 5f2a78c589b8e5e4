/// pelagic-render: pictures of an ocean.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <common/failure.hpp>
#include <common/program.hpp>
#include <common/progress.hpp>
#include <common/sea_json.hpp>
#include <common/sequence.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "renderer.hpp"
#include "stats.hpp"

namespace {

using Clock = std::chrono::steady_clock;

struct Options {
  common::Scene scene;
  common::Sequence sequence;
  render::RendererInfo renderer;
  std::string output = "ocean.png";
  std::string stats;
  bool listScenes = false;
};

const common::Choices<render::Aov>& aovs() {
  using render::Aov;
  static const common::Choices<Aov> choices{{"depth", Aov::depth}, {"position", Aov::position}, {"normal", Aov::normal},
                                            {"foam", Aov::foam},   {"variance", Aov::variance}, {"body", Aov::body}};
  return choices;
}

std::vector<render::Aov> parseAovs(const std::string& where, const std::string& text) {
  std::vector<render::Aov> list;
  for (const std::string& name : common::split(text, ',')) {
    const auto choice = std::find_if(aovs().begin(), aovs().end(), [&](const auto& c) { return c.first == name; });
    const bool again = choice != aovs().end() && std::find(list.begin(), list.end(), choice->second) != list.end();
    if (choice == aovs().end() || again) {
      common::refuse(where, text, common::names(aovs()) + ", each once, with commas");
    }
    list.push_back(choice->second);
  }
  return list;
}

common::Fields pictureFields(Options& options) {
  using Texts = std::vector<std::string>;
  render::RendererInfo& renderer = options.renderer;
  return {
      common::extentField("resolution", "Size of the picture", renderer.extent),
      {"aov", "NAME[,NAME...]", "Further channels of an .exr: " + common::names(aovs()),
       [&renderer](const std::string& where, const Texts& texts) { renderer.aovs = parseAovs(where, texts.front()); }},
      {"stats", "FILE.json", "Times, memory and the sea as JSON",
       [&options](const std::string&, const Texts& texts) { options.stats = texts.front(); }},
      {"output", "PATH", "Picture: .png tone mapped, .exr linear; with %04d the frames of a sequence",
       [&options](const std::string&, const Texts& texts) { options.output = texts.front(); }},
  };
}

render::Format formatOf(const std::string& path) {
  const auto ends = [&](std::string_view end) {
    return path.size() > end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0;
  };
  if (ends(".png")) return render::Format::png;
  if (ends(".exr")) return render::Format::exr;
  common::refuse("--output", path, "names that end in .png or .exr");
}

/// The name of frame `number`: `%d` or `%04d` in `pattern` stands for it.
std::string frameName(const std::string& pattern, std::uint64_t number, bool sequence) {
  const std::size_t percent = pattern.find('%');
  if (percent == std::string::npos) {
    if (sequence) common::refuse("--output", pattern, "names with %04d for the frame's number");
    return pattern;
  }
  const std::size_t d = pattern.find('d', percent);
  const std::string width = d == std::string::npos ? "?" : pattern.substr(percent + 1, d - percent - 1);
  const bool good = width.empty() || (width.size() == 2 && width[0] == '0' && width[1] >= '1' && width[1] <= '9');
  if (!good || pattern.find('%', percent + 1) != std::string::npos) {
    common::refuse("--output", pattern, "names with one %d or %01d to %09d for the frame's number");
  }
  const int digits = width.empty() ? 1 : width[1] - '0';
  return fmt::format("{}{:0{}}{}", pattern.substr(0, percent), number, digits, pattern.substr(d + 1));
}

void writeStats(const std::filesystem::path& path, const Options& options, const common::GpuDevice& gpu,
                const pelagic::Device& device, const render::Renderer& renderer, const render::Stats& stats,
                double firstFrame, std::span<const double> times) {
  const pelagic::MemoryUsage memory = device.memory();
  const auto bytes = [&](pelagic::Stage stage) { return memory[static_cast<std::size_t>(stage)]; };
  const nlohmann::ordered_json document{
      {"device", gpu.name()},
      {"resolution", {options.renderer.extent.width, options.renderer.extent.height}},
      {"passes", stats.passes()},
      {"frame_ms", stats.frame()},
      {"first_frame_ms", firstFrame},
      {"memory_bytes",
       {{"waves", bytes(pelagic::Stage::waves)},
        {"sky", bytes(pelagic::Stage::sky)},
        {"surface", bytes(pelagic::Stage::surface)},
        {"composite", bytes(pelagic::Stage::composite)}}},
      {"sea", common::seaJson(options.scene.sea, renderer.waves().maps().layout, renderer.waves().report(), times)},
      {"triangles", renderer.triangles()},
  };
  common::writeText(path, document.dump(2) + "\n");
}

void renderFrames(common::Program& program, const Options& options, Clock::time_point start,
                  common::OutputSet& outputs) {
  const std::vector<double> times = options.sequence.times();
  const bool sequence = options.sequence.frames > 0;
  const auto file = [&](std::size_t frame) {
    return outputs.add("--output", frameName(options.output, options.sequence.first + frame, sequence));
  };
  file(0);  // before the work: can it be written at all?
  const bool measure = !options.stats.empty();
  const std::filesystem::path statsFile = measure ? outputs.add("--stats", options.stats) : "";

  const common::GpuDevice gpu = program.openDevice();
  pelagic::Device device = common::unwrap(pelagic::Device::create(gpu.info()));
  render::Renderer renderer(gpu, device, options.renderer);
  double firstFrame = 0;
  render::Stats stats;
  // Frames that lead up to the first picture, so that medians are of five at least.
  for (int lead = render::kWarmUpFrames + render::kMeasuredFrames - 1; measure && lead > 0; --lead) {
    const auto passes = renderer.draw(times.front() - lead / 60.0);
    if (firstFrame == 0) {
      firstFrame = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    } else {
      stats.add(passes);
    }
  }
  common::Progress progress(static_cast<std::uint32_t>(times.size()));
  for (std::size_t frame = 0; frame < times.size(); ++frame) {
    stats.add(renderer.draw(times[frame]));
    renderer.write(file(frame));
    progress.step();
  }
  if (measure) writeStats(statsFile, options, gpu, device, renderer, stats, firstFrame, times);
}

}  // namespace

int main(int argc, char** argv) {
  const Clock::time_point start = Clock::now();
  common::Program program("pelagic-render", "Renders pictures of an ocean.");
  Options options;
  common::addSceneOptions(program, options.scene);
  program.app().add_flag("--list-scenes", options.listScenes, "Print the built-in scenes")->group("Scene");
  program.add(common::sequenceFields(options.sequence, true), "Time");
  program.add(pictureFields(options), "Output");
  return program.run(argc, argv, [&](common::OutputSet& outputs) {
    if (options.listScenes) {
      fmt::print("{}", common::listScenes());
      return;
    }
    common::checkSequence(program, true);
    if (!program.given("--time")) options.sequence.time = options.scene.time;
    options.renderer.format = formatOf(options.output);
    if (options.renderer.format == render::Format::png && program.given("--aov")) {
      common::refuse("--aov", program.app().get_option("--aov")->as<std::string>(), "only with an .exr as --output");
    }
    options.renderer.scene = options.scene;
    renderFrames(program, options, start, outputs);
  });
}
