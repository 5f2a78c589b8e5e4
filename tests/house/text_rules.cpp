#include <algorithm>
#include <regex>

#include "rules.hpp"

namespace house {

Findings lengthRules(const Tree& tree) {
  constexpr std::ptrdiff_t kMaxLines = 450;
  Findings findings;
  for (const File& file : tree) {
    const auto lines = std::count(file.text.begin(), file.text.end(), '\n');
    if ((isCode(file.path) || isShader(file.path)) && lines > kMaxLines) {
      findings.push_back(file.path + " has " + std::to_string(lines) + " lines");
    }
  }
  return findings;
}

Findings wordRules(const Tree& tree) {
  // Written so that this file does not hold the words itself.
  static const std::regex kForbidden(
      R"re(\b(T[O]DO|FIX[M]E|X[X]X|HA[C]K)\b|DISABLE[D]_|GTEST_S[K]IP|["' =(]/(wor[k]|hom[e]|roo[t]|User[s])/)re");
  Findings findings;
  for (const File& file : tree) {
    for (std::sregex_iterator match(file.text.begin(), file.text.end(), kForbidden), end; match != end; ++match) {
      findings.push_back(file.path + ":" +
                         std::to_string(lineOf(file.text, static_cast<std::size_t>(match->position()))) + " says '" +
                         match->str() + "'");
    }
  }
  return findings;
}

Findings sizeRules(const std::filesystem::path& root) {
  constexpr std::uintmax_t kMaxBytes = 200000;
  Findings findings;
  for (const char* folder : {"cmake", "docs", "examples", "include", "lib", "shaders", "tests"}) {
    if (!std::filesystem::exists(root / folder)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      if (entry.is_regular_file() && entry.file_size() > kMaxBytes) {
        findings.push_back(entry.path().lexically_relative(root).generic_string() + " has " +
                           std::to_string(entry.file_size()) + " bytes");
      }
    }
  }
  return findings;
}

}  // namespace house
