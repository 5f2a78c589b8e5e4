/// golden_update [SCENE...]: draws the built-in scenes, or those named, into the source tree as the new goldens.
/// Nothing else writes there; look at what changed before it is committed.
#include <cstdio>

#include "compare.hpp"
#include "draw.hpp"

int main(int argc, char** argv) try {
  std::vector<std::string> names(argv + 1, argv + argc);
  if (names.empty()) {
    for (const common::BuiltinScene& scene : common::builtinScenes()) names.emplace_back(scene.name);
  }
  const auto gpu = common::GpuDevice::create({});
  if (!gpu) throw std::runtime_error(gpu.error().message);
  for (const std::string& name : names) {
    const golden::Picture picture = golden::draw(*gpu, gpu->info(), golden::builtin(name));
    const auto path = golden::imageOf(name);
    std::string change = "new";
    if (std::filesystem::exists(path)) {
      const auto findings = golden::compare(golden::readPng(path), picture);
      change = findings.empty() ? "within tolerance" : findings.front();
    }
    golden::writePng(path, picture);
    std::printf("%s: %s\n", path.c_str(), change.c_str());
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "golden_update: %s\n", error.what());
  return 4;
}
