/// When two pictures of one scene count as the same.
#pragma once

#include <string>
#include <vector>

#include "picture.hpp"

namespace golden {

struct Tolerance {
  /// Another processor may round and fuse multiplications differently, which moves a channel by a step where a value
  /// lies at a rounding edge, and more where a crest's edge decides which of two waves a pixel shows.
  int pixelStep = 3;            ///< Steps of 1/255 that any channel may differ by …
  double pixelsBeyond = 0.002;  ///< … except in this share of the pixels.
  double blockMean = 0.005;     ///< Relative difference of a block's linear mean.
  double pictureMean = 0.001;   ///< Relative difference of the picture's linear mean: rounding averages out.
};
inline constexpr std::uint32_t kBlock = 16;  ///< Side of a block [px].

/// Sentences that say what differs by more than allowed; empty when the pictures agree.
std::vector<std::string> compare(const Picture& golden, const Picture& actual, const Tolerance& tolerance = {});

}  // namespace golden
