#include <algorithm>
#include <regex>
#include <set>

#include "rules.hpp"

namespace house {

namespace {

/// A shader's text with everything that it includes from the tree, each file once, in front of it.
std::string expanded(const Tree& tree, const File& file, std::set<std::string>& seen) {
  static const std::regex kInclude(R"re(#include[ \t]*[<"]([^>"]+)[>"])re");
  if (!seen.insert(file.path).second) return {};
  const std::string text = withoutComments(file.text);
  std::string result;
  for (std::sregex_iterator match(text.begin(), text.end(), kInclude), end; match != end; ++match) {
    const std::string own = file.path.substr(0, file.path.rfind('/') + 1);
    for (const std::string& folder : {own, std::string("shaders/"), std::string("include/")}) {
      const File* other = find(tree, folder + (*match)[1].str());
      if (other) {
        result += expanded(tree, *other, seen);
        break;
      }
    }
  }
  return result + text;
}

struct Function {
  std::string name;
  std::string body;
};

std::vector<Function> functionsOf(const std::string& text) {
  static const std::regex kHead(R"re((\w+)\s*\([^(){};]*\)\s*\{)re");
  std::vector<Function> functions;
  std::size_t from = 0;
  std::smatch match;
  std::string rest = text;
  while (std::regex_search(rest, match, kHead)) {
    from = static_cast<std::size_t>(match.position() + match.length());
    std::size_t end = from;
    for (int depth = 1; end < rest.size() && depth > 0; ++end) {
      depth += rest[end] == '{' ? 1 : rest[end] == '}' ? -1 : 0;
    }
    functions.push_back({match[1], rest.substr(from, end - from)});
    rest = rest.substr(end);
  }
  return functions;
}

/// Where the last call of one of `names` stands, npos without any.
std::size_t lastCall(const std::string& body, const std::set<std::string>& names) {
  static const std::regex kCall(R"re((\w+)\s*\()re");
  std::size_t last = std::string::npos;
  for (std::sregex_iterator match(body.begin(), body.end(), kCall), end; match != end; ++match) {
    if (names.contains((*match)[1])) last = static_cast<std::size_t>(match->position());
  }
  return last;
}

}  // namespace

Findings bindingRules(const Tree& tree) {
  static const std::regex kDeclaration(R"re(layout\s*\([^)]*\bbinding\b[^)]*\)([^;{]*)[;{])re");
  static const std::regex kStorage(R"re(\bbuffer\b|\b[iu]?image(1D|2D|3D|Cube|Buffer)(Array)?\b)re");
  static const std::regex kQualified(R"re(\b(readonly|writeonly)\b)re");
  Findings findings;
  for (const File& file : tree) {
    if (!isShader(file.path)) continue;
    const std::string text = withoutComments(file.text);
    for (std::sregex_iterator match(text.begin(), text.end(), kDeclaration), end; match != end; ++match) {
      const std::string declaration = (*match)[1];
      if (!std::regex_search(declaration, kStorage) || std::regex_search(declaration, kQualified)) continue;
      findings.push_back(file.path + ":" + std::to_string(lineOf(text, static_cast<std::size_t>(match->position()))) +
                         " binds neither readonly nor writeonly");
    }
  }
  return findings;
}

Findings barrierRules(const Tree& tree) {
  Findings findings;
  for (const File& file : tree) {
    if (!endsWith(file.path, ".comp")) continue;
    std::set<std::string> seen;
    std::set<std::string> waiting{"barrier"};
    // GLSL defines functions before their use, so one walk in order finds all that wait.
    for (const Function& function : functionsOf(expanded(tree, file, seen))) {
      const std::size_t wait = lastCall(function.body, waiting);
      if (wait == std::string::npos) continue;
      waiting.insert(function.name);
      static const std::regex kReturn(R"re(\breturn\b)re");
      const std::string before = function.body.substr(0, wait);
      if (std::regex_search(before, kReturn)) {
        findings.push_back(file.path + ": " + function.name + "() returns before a barrier()");
      }
    }
  }
  return findings;
}

Findings loopRules(const Tree& tree) {
  static const std::regex kUniformEnd(
      R"re(\b(while\s*\(|for\s*\([^{};]*;)[^{};]*[<>]=?\s*(frame|light)\.[\w.]+\s*[;)])re");
  Findings findings;
  for (const File& file : tree) {
    if (!file.path.starts_with("shaders/composite/")) continue;
    const std::string text = withoutComments(file.text);
    for (std::sregex_iterator match(text.begin(), text.end(), kUniformEnd), end; match != end; ++match) {
      findings.push_back(file.path + ":" + std::to_string(lineOf(text, static_cast<std::size_t>(match->position()))) +
                         " has a loop that ends at a uniform number");
    }
  }
  return findings;
}

}  // namespace house
