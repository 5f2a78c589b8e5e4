#include "program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "failure.hpp"
#include "settings_file.hpp"

namespace common {
namespace {

[[noreturn]] void needsValue(const std::string& name, const CLI::Option& option) {
  refuse(name, "", option.get_description());
}

}  // namespace

Program::Program(const std::string& name, const std::string& description) : app_(description, name) {
  app_.set_version_flag("--version", name + " " PELAGIC_VERSION);
  app_.add_option("--device", select_, "Index or a part of the name of a Vulkan device; default: the best there is")
      ->type_name("INDEX|NAME")
      ->group("Device");
  app_.add_flag("--validate", validate_, "Switch the Vulkan validation layer on; exit 3 if it says anything")
      ->group("Device");
}

void Program::add(const Fields& fields, const std::string& group) {
  for (const Field& field : fields) {
    const std::string name = "--" + field.name;
    app_.add_option_function<std::vector<std::string>>(
            name, [field, name](const std::vector<std::string>& texts) { field.set(name, texts); }, field.help)
        ->type_name(field.value)
        ->expected(1, field.repeatable ? CLI::detail::expected_max_vector_size : 1)
        ->allow_extra_args(false)
        ->group(group);
  }
}

void Program::addFile(const std::string& name, const std::string& help, const Fields& fields,
                      const std::string& group) {
  app_.add_option_function<std::string>(
          name, [fields, name](const std::string& path) { applySettings(path, readTextFile(name, path), fields); },
          help)
      ->type_name("FILE.toml")
      ->group(group);
}

bool Program::given(const std::string& name) const { return app_.count(name) > 0; }

/// Ties every option to the argument behind it, so that a value may begin with '-', as -inf does.
std::vector<std::string> Program::arguments(int argc, char** argv) const {
  std::vector<std::string> tied;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const std::size_t equals = argument.find('=');
    const std::string name = argument.substr(0, equals);
    const CLI::Option* option = name.compare(0, 2, "--") == 0 ? app_.get_option_no_throw(name) : nullptr;
    if (!option || option->get_items_expected_max() == 0) {
      tied.push_back(argument);
      continue;
    }
    if (equals == std::string::npos && i + 1 == argc) needsValue(name, *option);
    const std::string value = equals == std::string::npos ? argv[++i] : argument.substr(equals + 1);
    if (value.empty()) needsValue(name, *option);
    tied.push_back(name + "=" + value);
  }
  return tied;
}

void Program::parse(int argc, char** argv) {
  std::vector<std::string> tied = arguments(argc, argv);
  std::reverse(tied.begin(), tied.end());  // as CLI11 takes a vector
  app_.parse(tied);
}

int Program::run(int argc, char** argv, const std::function<void(OutputSet&)>& body) {
  const auto fail = [&](ExitCode code, std::string line) {
    std::replace(line.begin(), line.end(), '\n', ' ');
    fmt::print(stderr, "{}: {}\n", app_.get_name(), line);
    return static_cast<int>(code);
  };
  try {
    parse(argc, argv);
    OutputSet outputs;
    body(outputs);
    if (log_ && !log_->messages.empty()) {
      for (const std::string& message : log_->messages) fmt::print(stderr, "{}\n", message);
      return static_cast<int>(ExitCode::validation);
    }
    outputs.commit();
    return static_cast<int>(ExitCode::success);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app_.exit(error);  // --help, --version
    return fail(ExitCode::badInput, std::string(error.what()) + ", allowed: see --help");
  } catch (const Failure& failure) {
    return fail(failure.code(), failure.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::device, "out of memory");
  } catch (const std::exception& error) {
    return fail(ExitCode::device, error.what());
  }
}

GpuDevice Program::openDevice(GpuDeviceOptions options) {
  options.select = select_;
  options.validate = validate_;
  auto gpu = GpuDevice::create(options);
  if (!gpu) throw Failure(gpu.error().noMatch ? ExitCode::badInput : ExitCode::device, gpu.error().message);
  if (validate_) log_ = gpu->log();
  return std::move(*gpu);
}

}  // namespace common
