#include <algorithm>
#include <cmath>
#include <gpu/context.hpp>
#include <sstream>
#include <waves/gain_field.hpp>

namespace pelagic {
namespace {

constexpr float kLargest = 4;

template <class T>
tl::unexpected<Error> rejectField(const char* field, T value, const char* range) {
  std::ostringstream text;
  text << "GainMap::" << field << " is " << value << ", it must " << range;
  return gpu::reject(text.str());
}

}  // namespace

Result<void> validate(const GainMap& map, std::uint32_t cascades) {
  if (map.width == 0 && map.height == 0) {
    if (!map.gains.empty()) return rejectField("width", 0, "be 2 … 4096 where there are gains");
    return {};
  }
  if (map.width < 2 || map.width > 4096) return rejectField("width", map.width, "lie in 2 … 4096, or be 0 for no map");
  if (map.height < 2 || map.height > 4096) {
    return rejectField("height", map.height, "lie in 2 … 4096, or be 0 for no map");
  }
  if (map.bands != 1 && map.bands != cascades) {
    return rejectField("bands", map.bands, ("be 1 or the number of cascades, " + std::to_string(cascades)).c_str());
  }
  if (!(std::abs(map.origin.x) <= 1e9)) return rejectField("origin.x", map.origin.x, "lie in -1e9 … 1e9 m");
  if (!(std::abs(map.origin.y) <= 1e9)) return rejectField("origin.y", map.origin.y, "lie in -1e9 … 1e9 m");
  if (!(map.spacing >= 0.1 && map.spacing <= 1e6)) return rejectField("spacing", map.spacing, "lie in 0.1 … 1e6 m");
  const std::size_t count = std::size_t{map.width} * map.height * map.bands;
  if (map.gains.size() != count) {
    return rejectField("gains.size()", map.gains.size(),
                       ("be width x height x bands, " + std::to_string(count)).c_str());
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (map.gains[i] >= 0 && map.gains[i] <= kLargest) continue;
    return rejectField(("gains[" + std::to_string(i) + "]").c_str(), map.gains[i], "lie in 0 … 4");
  }
  return {};
}

Gain gainAt(const GainMap& map, std::uint32_t cascade, const glm::dvec2& point) noexcept {
  if (map.width == 0) return {};
  const glm::dvec2 last(map.width - 1, map.height - 1);
  const glm::dvec2 wanted = (point - map.origin) / map.spacing;
  if (std::isnan(wanted.x) || std::isnan(wanted.y)) return {};
  const glm::dvec2 at = glm::clamp(wanted, glm::dvec2(0), last);
  const glm::dvec2 cell = glm::min(glm::floor(at), last - 1.0);
  const glm::vec2 f(at - cell);
  const std::size_t band = map.bands == 1 ? 0 : cascade;
  const float* corner = map.gains.data() + (band * map.height + static_cast<std::size_t>(cell.y)) * map.width +
                        static_cast<std::size_t>(cell.x);
  const float a = corner[0], b = corner[1], c = corner[map.width], d = corner[map.width + 1];
  const auto perMetre = static_cast<float>(1 / map.spacing);
  Gain gain;
  gain.value = glm::mix(glm::mix(a, b, f.x), glm::mix(c, d, f.x), f.y);
  // Beyond an edge it no longer changes across it.
  gain.alongX = wanted.x == at.x ? glm::mix(b - a, d - c, f.y) * perMetre : 0;
  gain.alongZ = wanted.y == at.y ? glm::mix(c - a, d - b, f.x) * perMetre : 0;
  return gain;
}

double largestGain(const GainMap& map) noexcept {
  return map.gains.empty() ? 1 : static_cast<double>(*std::max_element(map.gains.begin(), map.gains.end()));
}

}  // namespace pelagic
