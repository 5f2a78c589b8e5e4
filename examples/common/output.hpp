/// Output files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace common {

/// Files are written under temporary names beside their own and take these in commit(). What was not committed is
/// removed by the destructor.
class OutputSet {
 public:
  OutputSet() = default;
  OutputSet(const OutputSet&) = delete;
  OutputSet& operator=(const OutputSet&) = delete;
  ~OutputSet();

  /// Where to write the file that will be called `path`; the same path gives the same answer.
  /// Throws a Failure that names `option` when no file can be written there.
  std::filesystem::path add(const std::string& option, const std::filesystem::path& path);
  /// Makes `path` a directory, with its parents; those that were made are removed again on failure.
  void addDirectory(const std::string& option, const std::filesystem::path& path);
  void commit();

 private:
  struct File {
    std::filesystem::path temporary;
    std::filesystem::path path;
    std::string option;
  };
  std::vector<File> files_;
  std::vector<std::filesystem::path> directories_;  ///< Made here, outermost first.
};

/// Writes a whole text file at a path from OutputSet::add.
void writeText(const std::filesystem::path& path, const std::string& text);

}  // namespace common
