#include "tree.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

namespace house {

namespace {

bool hasEnding(const std::string& path, const auto& endings) {
  return std::any_of(endings.begin(), endings.end(), [&](const char* end) { return endsWith(path, end); });
}

bool isText(const std::string& path) {
  constexpr std::array kEndings{".md",  ".txt", ".cmake", ".in",   ".json",         ".sh",         ".toml",
                                "/run", ".csv", ".yml",   ".html", ".clang-format", ".clang-tidy", ".gitignore"};
  return isCode(path) || isShader(path) || hasEnding(path, kEndings);
}

std::string read(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

bool endsWith(const std::string& text, const std::string& end) { return text.ends_with(end); }
bool startsWith(const std::string& text, const std::string& start) { return text.starts_with(start); }

bool isCode(const std::string& path) {
  constexpr std::array kEndings{".cpp", ".hpp", ".h"};
  return hasEnding(path, kEndings);
}

bool isShader(const std::string& path) {
  constexpr std::array kEndings{".glsl", ".comp", ".vert", ".frag"};
  const bool shared =
      endsWith(path, ".h") && (startsWith(path, "shaders/") || startsWith(path, "include/pelagic/shader/"));
  return shared || hasEnding(path, kEndings);
}

Tree readTree(const std::filesystem::path& root) {
  Tree tree;
  for (auto entry = std::filesystem::recursive_directory_iterator(root); entry != std::filesystem::end(entry);
       ++entry) {
    const std::string path = entry->path().lexically_relative(root).generic_string();
    const std::string name = entry->path().filename().string();
    // Build trees and what belongs to git or editors are not the project.
    const bool foreign = startsWith(path, "build") || name == ".git" || name == ".cache" || name == "shared";
    if (entry->is_directory() && foreign && path.find('/') == std::string::npos) entry.disable_recursion_pending();
    if (entry->is_regular_file() && isText(path)) tree.push_back({path, read(entry->path())});
  }
  std::sort(tree.begin(), tree.end(), [](const File& a, const File& b) { return a.path < b.path; });
  return tree;
}

const File* find(const Tree& tree, const std::string& path) {
  const auto found = std::find_if(tree.begin(), tree.end(), [&](const File& file) { return file.path == path; });
  return found == tree.end() ? nullptr : &*found;
}

std::string withoutComments(const std::string& text) {
  std::string result = text;
  std::size_t i = 0;
  const auto blank = [&](std::size_t end) {
    for (; i < std::min(end, result.size()); ++i) {
      if (result[i] != '\n') result[i] = ' ';
    }
  };
  while (i < text.size()) {
    if (text.compare(i, 2, "//") == 0) {
      blank(text.find('\n', i));
    } else if (text.compare(i, 2, "/*") == 0) {
      const std::size_t end = text.find("*/", i + 2);
      blank(end == std::string::npos ? end : end + 2);
    } else {
      ++i;
    }
  }
  return result;
}

std::size_t lineOf(const std::string& text, std::size_t position) {
  return 1 +
         static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(position), '\n'));
}

}  // namespace house
