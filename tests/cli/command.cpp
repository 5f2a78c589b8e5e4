#include "command.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace cli {
namespace fs = std::filesystem;
namespace {

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

CommandTest::CommandTest() {
  std::string pattern = (fs::temp_directory_path() / "pelagic-cli-XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("cannot make a temporary directory");
  directory_ = pattern;
}

CommandTest::~CommandTest() {
  std::error_code ignored;
  fs::remove_all(directory_, ignored);
}

Outcome CommandTest::run(const std::string& program, const std::string& arguments, const std::string& before) const {
  const fs::path out = directory_.string() + ".out";
  const fs::path err = directory_.string() + ".err";
  const std::string command = fmt::format("cd '{}' && {} '{}/pelagic-{}' {} >'{}' 2>'{}'", directory_.string(), before,
                                          PELAGIC_BIN_DIR, program, arguments, out.string(), err.string());
  const int raw = std::system(command.c_str());
  Outcome outcome{WIFEXITED(raw) ? WEXITSTATUS(raw) : -1, contents(out), contents(err)};
  fs::remove(out);
  fs::remove(err);
  return outcome;
}

void CommandTest::succeed(const std::string& program, const std::string& arguments, const std::string& before) const {
  const Outcome outcome = run(program, arguments, before);
  EXPECT_EQ(outcome.status, 0) << program << " " << arguments << "\n" << outcome.err;
  EXPECT_EQ(outcome.err, "");
}

void CommandTest::refused(const std::string& program, const std::string& arguments,
                          const std::vector<std::string>& names) const {
  const Outcome outcome = run(program, arguments);
  const std::string said = program + " " + arguments + "\n" + outcome.err;
  EXPECT_EQ(outcome.status, 2) << said;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << said;
  for (const std::string& name : names) EXPECT_NE(outcome.err.find(name), std::string::npos) << name << " in\n" << said;
  EXPECT_EQ(outcome.out, "") << said;
  EXPECT_EQ(files(), std::vector<std::string>{}) << said;
}

std::vector<std::string> CommandTest::files() const {
  std::vector<std::string> list;
  for (const auto& entry : fs::recursive_directory_iterator(directory_)) {
    const std::string name = fs::relative(entry.path(), directory_).string();
    if (std::find(written_.begin(), written_.end(), name) == written_.end()) list.push_back(name);
  }
  std::sort(list.begin(), list.end());
  return list;
}

void CommandTest::writeFile(const std::string& name, const std::string& text) {
  std::ofstream(path(name), std::ios::binary) << text;
  written_.push_back(name);
}

std::string CommandTest::readText(const std::string& name) const { return contents(path(name)); }

nlohmann::json CommandTest::readJson(const std::string& name) const { return nlohmann::json::parse(readText(name)); }

}  // namespace cli
