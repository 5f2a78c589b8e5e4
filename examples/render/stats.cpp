#include "stats.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace render {
namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

}  // namespace

void Stats::add(std::span<const pelagic::Timings::Pass> passes) {
  std::map<std::string, double> frame;
  double total = 0;
  for (const pelagic::Timings::Pass& pass : passes) {
    if (milliseconds_.find(pass.name) == milliseconds_.end()) {
      order_.emplace_back(pass.name);
      milliseconds_[pass.name];
    }
    frame[pass.name] += pass.milliseconds;
    total += pass.milliseconds;
  }
  for (const auto& [name, milliseconds] : frame) milliseconds_[name].push_back(milliseconds);
  frames_.push_back(total);
}

nlohmann::ordered_json Stats::passes() const {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const std::string& name : order_) list.push_back({{"name", name}, {"ms", median(milliseconds_.at(name))}});
  return list;
}

double Stats::frame() const { return median(frames_); }

}  // namespace render
