/// How the example programs fail: an exit status and one line.
#pragma once

#include <pelagic/result.hpp>
#include <stdexcept>
#include <string>

namespace common {

enum class ExitCode {
  success = 0,
  badInput = 2,    ///< An option or an input file; the message names it, the value and what is allowed.
  validation = 3,  ///< The validation layer spoke.
  device = 4,      ///< No device, no memory, or a driver's error.
};

class Failure : public std::runtime_error {
 public:
  Failure(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// The value, or a Failure: what the library calls an invalid argument came from the user.
template <class T>
T unwrap(pelagic::Result<T> result) {
  if (!result) {
    const bool bad = result.error().code == pelagic::ErrorCode::invalidArgument;
    throw Failure(bad ? ExitCode::badInput : ExitCode::device, result.error().message);
  }
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}

}  // namespace common
