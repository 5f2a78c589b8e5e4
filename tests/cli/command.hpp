/// Runs the example programs as a user does: in a directory of their own, judged by status, text and files.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cli {

struct Outcome {
  int status = -1;
  std::string out;
  std::string err;
};

/// A fresh directory per test, removed afterwards.
class CommandTest : public testing::Test {
 protected:
  CommandTest();
  ~CommandTest() override;

  /// Runs pelagic-`program` in the directory. `arguments` and `before`, what starts it, are words of a shell.
  Outcome run(const std::string& program, const std::string& arguments, const std::string& before = "") const;
  /// Runs it and expects success and silence on stderr.
  void succeed(const std::string& program, const std::string& arguments, const std::string& before = "") const;
  /// Expects status 2, one line on stderr that holds every one of `names`, and no file left behind.
  void refused(const std::string& program, const std::string& arguments, const std::vector<std::string>& names) const;

  /// Paths of all files below the directory, relative and sorted; those with `kept` names are left out.
  std::vector<std::string> files() const;
  std::filesystem::path path(const std::string& name) const { return directory_ / name; }
  void writeFile(const std::string& name, const std::string& text);
  std::string readText(const std::string& name) const;
  nlohmann::json readJson(const std::string& name) const;

 private:
  std::filesystem::path directory_;
  std::vector<std::string> written_;  ///< By the test itself.
};

}  // namespace cli
