/// The frame of every example program: options, device, exit status.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>

#include "field.hpp"
#include "gpu_device.hpp"
#include "output.hpp"

namespace common {

class Program {
 public:
  Program(const std::string& name, const std::string& description);

  /// Options run in the order in which they were added, whatever the order on the command line.
  CLI::App& app() { return app_; }
  const CLI::App& app() const { return app_; }
  /// One option per field.
  void add(const Fields& fields, const std::string& group);
  /// `--name FILE`, whose keys are `fields`; add it before them, so that they override the file.
  void addFile(const std::string& name, const std::string& help, const Fields& fields, const std::string& group);
  /// Was the option `name` given?
  bool given(const std::string& name) const;

  /// Parses, runs `body` and commits its outputs if it succeeded and the validation layer kept silent.
  /// `body` has to destroy its device. Returns the exit status.
  int run(int argc, char** argv, const std::function<void(OutputSet&)>& body);
  /// The device that --device and --validate ask for; other options' extensions in `options`.
  GpuDevice openDevice(GpuDeviceOptions options = {});

 private:
  std::vector<std::string> arguments(int argc, char** argv) const;
  void parse(int argc, char** argv);

  CLI::App app_;
  std::string select_;
  bool validate_ = false;
  std::shared_ptr<const ValidationLog> log_;
};

}  // namespace common
