/// The source tree as text.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace house {

struct File {
  std::string path;  ///< From the root, with '/'.
  std::string text;
};
using Tree = std::vector<File>;
/// One sentence each: file, line where known, and what is wrong with it.
using Findings = std::vector<std::string>;

/// Every text file of the project: code, shaders, scripts and documents.
Tree readTree(const std::filesystem::path& root);
const File* find(const Tree& tree, const std::string& path);

bool isCode(const std::string& path);    ///< C++, including headers that GLSL shares.
bool isShader(const std::string& path);  ///< GLSL, including headers that C++ shares.
bool endsWith(const std::string& text, const std::string& end);
bool startsWith(const std::string& text, const std::string& start);

/// The same text, every comment as spaces; lines keep their numbers.
std::string withoutComments(const std::string& text);
/// 1 for the first line.
std::size_t lineOf(const std::string& text, std::size_t position);

}  // namespace house
