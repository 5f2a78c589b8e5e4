/// TOML files: a flat table whose keys are the names of fields.
#pragma once

#include "field.hpp"

namespace common {

/// The whole file. Throws a Failure that names `option` and the path when it cannot be read.
std::string readTextFile(const std::string& option, const std::string& path);
/// Applies every key of the TOML `text` to the field of that name, in the fields' order as options are. `name` is the
/// file's, for messages.
/// Throws a Failure with file and line for text that is no TOML, unknown keys and values out of range.
void applySettings(const std::string& name, std::string_view text, const Fields& fields);

}  // namespace common
