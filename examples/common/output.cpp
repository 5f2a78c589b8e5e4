#include "output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "failure.hpp"
#include "field.hpp"

namespace common {
namespace fs = std::filesystem;

OutputSet::~OutputSet() {
  std::error_code ignored;
  for (const File& file : files_) fs::remove(file.temporary, ignored);
  for (auto made = directories_.rbegin(); made != directories_.rend(); ++made) fs::remove(*made, ignored);
}

fs::path OutputSet::add(const std::string& option, const fs::path& path) {
  const auto known = std::find_if(files_.begin(), files_.end(), [&](const File& file) { return file.path == path; });
  if (known != files_.end() && known->option != option) {
    refuse(option, path.string(), "another file than that of " + known->option);
  }
  if (known != files_.end()) return known->temporary;
  std::error_code none;
  const std::string allowed = "a file name in a directory that exists and can be written";
  if (!path.has_filename() || fs::is_directory(path, none)) refuse(option, path.string(), allowed);
  const fs::path temporary = path.parent_path() / fmt::format(".{}.{}.part", path.filename().string(), getpid());
  if (!std::ofstream(temporary, std::ios::binary)) refuse(option, path.string(), allowed);
  files_.push_back({temporary, path, option});
  return temporary;
}

void OutputSet::addDirectory(const std::string& option, const fs::path& path) {
  std::error_code error;
  fs::path whole;
  for (const fs::path& part : path) {
    whole /= part;
    if (fs::create_directory(whole, error)) directories_.push_back(whole);
  }
  if (!fs::is_directory(path, error)) {
    refuse(option, path.string(), "a directory that exists or can be made");
  }
}

void OutputSet::commit() {
  for (const File& file : files_) {
    std::error_code error;
    fs::rename(file.temporary, file.path, error);
    if (error)
      throw Failure(ExitCode::device, fmt::format("cannot write '{}': {}", file.path.string(), error.message()));
  }
  files_.clear();
  directories_.clear();
}

void writeText(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw Failure(ExitCode::device, fmt::format("cannot write '{}': is the disk full?", path.string()));
}

}  // namespace common
