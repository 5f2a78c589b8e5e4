/// pelagic-query: the sea at single points, from the CPU and from the GPU, as a table.
#include <fmt/format.h>

#include <common/failure.hpp>
#include <common/program.hpp>
#include <common/progress.hpp>
#include <common/sea_options.hpp>
#include <pelagic/point_query.hpp>
#include <vulkan/vulkan.hpp>

#include "points_file.hpp"

namespace {

struct Options {
  common::SeaSettings sea;
  std::vector<double> times{0};  ///< [s]
  std::string points;
  std::string output;
};

void addRows(std::string& table, double time, const std::vector<glm::dvec2>& asked,
             const std::vector<pelagic::SurfacePoint>& cpu, const std::vector<pelagic::SurfacePoint>& gpu) {
  const auto add = [&](const glm::dvec2& at, const pelagic::SurfacePoint& p, const char* source) {
    const auto three = [](const glm::dvec3& v) { return fmt::format("{:.9g},{:.9g},{:.9g}", v.x, v.y, v.z); };
    // Places and times as asked for, to the last bit.
    table += fmt::format("{},{},{},{:.9g},{},{},{},{}\n", time, at.x, at.y, p.position.y, three(p.normal),
                         three(p.velocity), three(p.acceleration), source);
  };
  for (std::size_t i = 0; i < asked.size(); ++i) {
    add(asked[i], cpu[i], "cpu");
    add(asked[i], gpu[i], "gpu");
  }
}

std::string tableOf(common::Program& program, const Options& options, const std::vector<glm::dvec2>& points) {
  const pelagic::WavesInfo info = common::wavesInfo(options.sea, pelagic::MapPrecision::single);
  const common::GpuDevice gpu = program.openDevice();
  pelagic::Device device = common::unwrap(pelagic::Device::create(gpu.info()));
  pelagic::Waves waves = common::unwrap(pelagic::Waves::create(device, info));
  pelagic::PointQueryInfo queryInfo;
  queryInfo.capacity = static_cast<std::uint32_t>(points.size());
  pelagic::PointQuery gpuQuery = common::unwrap(pelagic::PointQuery::create(device, waves, queryInfo));
  pelagic::SeaQuery cpuQuery = common::unwrap(pelagic::SeaQuery::create(info));

  std::string table = "time,x,z,height,nx,ny,nz,vx,vy,vz,ax,ay,az,source\n";
  std::vector<pelagic::SurfacePoint> onGpu(points.size());
  std::vector<pelagic::SurfacePoint> onCpu(points.size());
  common::Progress progress(static_cast<std::uint32_t>(options.times.size()));
  for (const double time : options.times) {
    std::uint64_t ticket = 0;
    gpu.run([&](vk::CommandBuffer commands) {
      waves.record(commands, time);
      ticket = common::unwrap(gpuQuery.record(commands, points));
    });
    common::unwrap(gpuQuery.read(ticket, onGpu));
    cpuQuery.setTime(time);
    for (std::size_t i = 0; i < points.size(); ++i) onCpu[i] = cpuQuery.at(points[i]);
    addRows(table, time, points, onCpu, onGpu);
    progress.step();
  }
  return table;
}

}  // namespace

int main(int argc, char** argv) {
  common::Program program("pelagic-query",
                          "Writes height, normal, velocity and acceleration of the sea at points, as the CPU and the "
                          "GPU find them.");
  Options options;
  const common::Fields sea = common::seaFields(options.sea);
  program.addFile("--sea", "Options of the sea from a file; its keys are their names, options override it", sea, "Sea");
  program.add(sea, "Sea");
  program.app()
      .add_option("--points", options.points, "File of points, a line x,z each [m], -1e9 to 1e9 m")
      ->type_name("FILE.csv")
      ->group("Points");
  program.add({{"time", "S[,S...]", "The moments, each -1e9 to 1e9 s; default 0",
                [&options](const std::string& where, const std::vector<std::string>& texts) {
                  options.times.clear();
                  for (const std::string& part : common::split(texts.front(), ',')) {
                    options.times.push_back(
                        common::parsePart(where, texts.front(), part, "numbers with commas, each", {-1e9, 1e9, "s"}));
                  }
                }}},
              "Points");
  program.app()
      .add_option("--output", options.output, "File for the table: time,x,z,height,nx,ny,nz,vx,vy,vz,ax,ay,az,source")
      ->type_name("FILE.csv")
      ->group("Output");
  return program.run(argc, argv, [&](common::OutputSet& outputs) {
    if (options.points.empty()) common::refuse("--points", "", "a file of lines x,z, it must be given");
    if (options.output.empty()) common::refuse("--output", "", "a file name, it must be given");
    const std::vector<glm::dvec2> points = query::readPoints("--points", options.points);
    const auto output = outputs.add("--output", options.output);
    common::writeText(output, tableOf(program, options, points));
  });
}
