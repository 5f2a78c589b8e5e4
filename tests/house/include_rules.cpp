#include <optional>
#include <regex>
#include <set>

#include "rules.hpp"

namespace house {

namespace {

/// The room of a file: "include", "lib/gpu", "lib/<stage>", "lib" for the facade, "shaders/<folder>", "examples",
/// "tests/<folder>".
std::string roomOf(const std::string& path) {
  const std::size_t first = path.find('/');
  if (first == std::string::npos) return "";
  const std::string top = path.substr(0, first);
  const std::size_t second = path.find('/', first + 1);
  if (top == "include" || top == "examples" || second == std::string::npos) return top;
  return path.substr(0, second);
}

/// Rooms that `room` may include from besides itself; no value: any.
std::optional<std::set<std::string>> allowedRooms(const std::string& room) {
  if (room == "include") return std::set<std::string>{};
  if (room == "lib/gpu") return std::set<std::string>{"include"};
  if (room == "lib") return std::nullopt;
  if (startsWith(room, "lib/")) {
    return std::set<std::string>{"include", "lib/gpu", "shaders/shared", "shaders/physics",
                                 "shaders/" + room.substr(4)};
  }
  if (room == "shaders/physics") return std::set<std::string>{"include"};
  if (room == "shaders/shared") return std::set<std::string>{"include", "shaders/physics"};
  if (startsWith(room, "shaders/")) return std::set<std::string>{"include", "shaders/shared", "shaders/physics"};
  if (room == "examples") return std::set<std::string>{"include"};
  if (room == "tests/golden" || room == "tests/bench") {
    return std::set<std::string>{"include", "examples", "tests/support"};
  }
  if (room == "tests/consumer" || room == "tests/readme") return std::set<std::string>{"include"};
  return std::nullopt;
}

/// The file in the tree that `name` means in `from`, empty for one from outside.
std::string resolve(const Tree& tree, const std::string& from, const std::string& name) {
  const std::string own = from.substr(0, from.rfind('/') + 1);
  for (const std::string& folder : {own, std::string("include/"), std::string("lib/"), std::string("shaders/"),
                                    std::string("examples/"), std::string("tests/")}) {
    const std::string path = std::filesystem::path(folder + name).lexically_normal().generic_string();
    if (find(tree, path)) return path;
  }
  return {};
}

bool isStandard(const std::string& name) {
  return name.find('/') == std::string::npos && name.find('.') == std::string::npos;
}

/// What include/ and lib/ may take from outside the project.
bool allowedOutside(const std::string& room, const std::string& name) {
  const bool lib = room == "lib" || startsWith(room, "lib/");
  if (room != "include" && !lib) return true;
  return isStandard(name) || startsWith(name, "glm/") || name == "tl/expected.hpp" || name == "vulkan/vulkan_core.h" ||
         (lib && (name == "vulkan/vulkan.hpp" || endsWith(name, ".spv.hpp")));
}

}  // namespace

Findings includeRules(const Tree& tree) {
  static const std::regex kInclude(R"re((^|\n)[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"])re");
  Findings findings;
  for (const File& file : tree) {
    if (!isCode(file.path) && !isShader(file.path)) continue;
    const std::string room = roomOf(file.path);
    const auto allowed = allowedRooms(room);
    for (std::sregex_iterator match(file.text.begin(), file.text.end(), kInclude), end; match != end; ++match) {
      const std::string name = (*match)[2];
      const std::string target = resolve(tree, file.path, name);
      const std::string other = roomOf(target);
      const bool fine =
          target.empty() ? allowedOutside(room, name) : other == room || !allowed || allowed->contains(other);
      if (!fine) findings.push_back(file.path + " must not include " + (target.empty() ? name : target));
    }
  }
  return findings;
}

}  // namespace house
