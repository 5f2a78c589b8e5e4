#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace common {

Progress::Progress(std::uint32_t total) : total_(total), shown_(total > 1 && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (shown_ && done_ > 0) fmt::print(stderr, "\n");
}

void Progress::step() {
  ++done_;
  if (!shown_) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  const double left = elapsed.count() / done_ * (total_ - done_);
  fmt::print(stderr, "\rframe {} of {}, {:.0f} s left   ", done_, total_, left);
  std::fflush(stderr);
}

}  // namespace common
