#include "compare.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace golden {

namespace {

/// Undoes the square root of Picture's curve: linear in the light that a screen would show.
double linear(std::uint8_t value) { return value / 255.0 * (value / 255.0); }

struct Region {
  std::uint32_t x, y, width, height;
};

double mean(const Picture& picture, const Region& region, std::uint32_t channel) {
  double sum = 0;
  for (std::uint32_t y = region.y; y < region.y + region.height; ++y) {
    for (std::uint32_t x = region.x; x < region.x + region.width; ++x) {
      sum += linear(picture.rgb[(std::size_t{y} * picture.width + x) * 3 + channel]);
    }
  }
  return sum / (region.width * region.height);
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f %%", 100 * share);
  return text;
}

/// Largest relative difference of the regions' means, and where it is.
struct Worst {
  double difference = 0;
  Region region{};
};
void consider(Worst& worst, const Picture& golden, const Picture& actual, const Region& region) {
  // Below a step in linear light a mean says nothing.
  constexpr double kLeast = 1.0 / (255 * 255);
  for (std::uint32_t channel = 0; channel < 3; ++channel) {
    const double expected = mean(golden, region, channel);
    const double difference = std::abs(mean(actual, region, channel) - expected) / std::max(expected, kLeast);
    if (difference > worst.difference) worst = {difference, region};
  }
}

double shareBeyond(const Picture& golden, const Picture& actual, int step) {
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < golden.rgb.size(); i += 3) {
    int largest = 0;
    for (std::size_t c = i; c < i + 3; ++c) largest = std::max(largest, std::abs(golden.rgb[c] - actual.rgb[c]));
    beyond += largest > step;
  }
  return static_cast<double>(beyond) / (static_cast<double>(golden.rgb.size()) / 3);
}

}  // namespace

std::vector<std::string> compare(const Picture& golden, const Picture& actual, const Tolerance& tolerance) {
  if (golden.width != actual.width || golden.height != actual.height) return {"the pictures differ in size"};
  std::vector<std::string> findings;
  const double beyond = shareBeyond(golden, actual, tolerance.pixelStep);
  if (beyond > tolerance.pixelsBeyond) {
    findings.push_back(percent(beyond) + " of the pixels differ by more than " + std::to_string(tolerance.pixelStep) +
                       "/255, allowed " + percent(tolerance.pixelsBeyond));
  }
  Worst block;
  for (std::uint32_t y = 0; y < golden.height; y += kBlock) {
    for (std::uint32_t x = 0; x < golden.width; x += kBlock) {
      consider(block, golden, actual, {x, y, std::min(kBlock, golden.width - x), std::min(kBlock, golden.height - y)});
    }
  }
  if (block.difference > tolerance.blockMean) {
    findings.push_back("the block at (" + std::to_string(block.region.x) + ", " + std::to_string(block.region.y) +
                       ") has a mean that differs by " + percent(block.difference) + ", allowed " +
                       percent(tolerance.blockMean));
  }
  Worst whole;
  consider(whole, golden, actual, {0, 0, golden.width, golden.height});
  if (whole.difference > tolerance.pictureMean) {
    findings.push_back("the picture's mean differs by " + percent(whole.difference) + ", allowed " +
                       percent(tolerance.pictureMean));
  }
  return findings;
}

}  // namespace golden
