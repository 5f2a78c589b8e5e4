/// Medians of what frames cost.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <pelagic/timings.hpp>
#include <string>
#include <vector>

namespace render {

/// Frames before the first one that is measured, and measured frames at least.
inline constexpr int kWarmUpFrames = 1;
inline constexpr int kMeasuredFrames = 5;

class Stats {
 public:
  void add(std::span<const pelagic::Timings::Pass> passes);
  /// [{"name","ms"}] in recording order; a pass that not every frame has is the median of those that have it.
  nlohmann::ordered_json passes() const;
  /// Median of the frames' sums over their passes.
  double frame() const;

 private:
  std::vector<std::string> order_;
  std::map<std::string, std::vector<double>> milliseconds_;
  std::vector<double> frames_;
};

}  // namespace render
