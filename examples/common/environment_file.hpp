/// Pictures of the sky.
#pragma once

#include <pelagic/sky.hpp>
#include <string>

namespace common {

/// Sets the picture of `environment`; "none": no picture. Throws a Failure that names `where`, the file and what is
/// wrong with it.
void readEnvironment(const std::string& where, const std::string& path, pelagic::SkyEnvironment& environment);

}  // namespace common
