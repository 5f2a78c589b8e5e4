/// The frames of a run: one moment or a sequence.
#pragma once

#include <vector>

#include "program.hpp"

namespace common {

/// --time S | --frames N --fps F [--first I]: frame i is the moment i / F.
struct Sequence {
  double time = 0;           ///< [s]
  std::uint64_t frames = 0;  ///< 0: the one moment `time`.
  double rate = 24;          ///< [1/s]
  std::uint64_t first = 0;   ///< Number of the first frame.

  std::vector<double> times() const;
};

/// Setters of `sequence`, which must outlive them.
Fields sequenceFields(Sequence& sequence, bool withFirst);
/// Refuses --time beside --frames, and --fps or --first without it.
void checkSequence(const Program& program, bool withFirst);

}  // namespace common
