/// A line on a terminal that counts frames.
#pragma once

#include <chrono>
#include <cstdint>

namespace common {

/// Prints nothing when standard error is no terminal or there is only one frame.
class Progress {
 public:
  explicit Progress(std::uint32_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();
  void step();

 private:
  std::uint32_t total_;
  std::uint32_t done_ = 0;
  bool shown_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace common
