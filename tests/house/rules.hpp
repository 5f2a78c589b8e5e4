/// The rules of the house. Each returns what breaks it in `tree`.
#pragma once

#include "tree.hpp"

namespace house {

/// Who may include whom (ARCHITECTURE.md, "Folders").
Findings includeRules(const Tree& tree);
/// Every storage buffer and storage image of a shader is `readonly` or `writeonly`: no pass works in place, and
/// synchronisation validation sees every hazard.
Findings bindingRules(const Tree& tree);
/// In a shader no function returns before a barrier() that it, or what it calls, still has to reach.
Findings barrierRules(const Tree& tree);
/// No loop of the composite shaders ends at a uniform number by itself (notWrittenIn() in bindings.glsl).
Findings loopRules(const Tree& tree);
/// Code and shaders have at most 450 lines.
Findings lengthRules(const Tree& tree);
/// No note to do something later, no switched-off test, no path of somebody's machine.
Findings wordRules(const Tree& tree);
/// Files below `root` that are larger than 200 000 bytes: pictures and goldens stay small.
Findings sizeRules(const std::filesystem::path& root);

}  // namespace house
