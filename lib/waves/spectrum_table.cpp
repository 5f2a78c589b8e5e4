#include <algorithm>
#include <cmath>
#include <gpu/context.hpp>
#include <numbers>
#include <sstream>
#include <waves/spectrum_table.hpp>

namespace pelagic {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

tl::unexpected<Error> rejectEntry(const char* list, std::size_t index, double value, const char* range) {
  std::ostringstream text;
  text << "SeaState::table." << list << '[' << index << "] is " << value << ", it must " << range;
  return gpu::reject(text.str());
}

Result<void> checkCount(const char* list, std::size_t count, std::size_t low, std::size_t high) {
  if (count >= low && count <= high) return {};
  std::ostringstream text;
  text << "SeaState::table." << list << " has " << count << " entries, it must have " << low;
  if (high > low) text << " … " << high;
  return gpu::reject(text.str());
}

/// Two neighbouring entries and the share of the second.
struct Place {
  std::size_t low = 0, high = 0;
  double share = 0;
  double tail = 1;  ///< Factor beyond the last frequency; 0 below the first.
};

Place placeOf(const SpectrumTable& table, double frequency) noexcept {
  const auto& f = table.frequency;
  const std::size_t last = f.size() - 1;
  if (frequency < f.front()) return {0, 0, 0, 0};
  if (frequency >= f.back()) return {last, last, 0, std::pow(f.back() / frequency, 5)};
  const auto high = static_cast<std::size_t>(std::upper_bound(f.begin(), f.end(), frequency) - f.begin());
  return {high - 1, high, (frequency - f[high - 1]) / (f[high] - f[high - 1]), 1};
}

/// The same around the turn.
Place placeAround(const std::vector<double>& directions, double direction) noexcept {
  const double from = directions.front();
  const double turned = direction - from;
  const double at = from + turned - kTwoPi * std::floor(turned / kTwoPi);
  const auto next =
      static_cast<std::size_t>(std::upper_bound(directions.begin(), directions.end(), at) - directions.begin());
  const std::size_t low = next - 1;
  const std::size_t high = next % directions.size();
  const double end = high == 0 ? from + kTwoPi : directions[high];
  return {low, high, (at - directions[low]) / (end - directions[low]), 1};
}

/// S(f) of an entry over all directions, exact for density linear between directions [m^2/Hz].
double entryDensity(const SpectrumTable& table, std::size_t entry) noexcept {
  const auto& directions = table.direction;
  if (directions.empty()) return table.density[entry];
  const double* density = table.density.data() + entry * directions.size();
  double sum = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const bool wraps = i + 1 == directions.size();
    const double end = wraps ? directions.front() + kTwoPi : directions[i + 1];
    sum += 0.5 * (density[i] + density[wraps ? 0 : i + 1]) * (end - directions[i]);
  }
  return sum;
}

Result<void> checkRising(const char* list, const std::vector<double>& values, double low, double high,
                         const char* range) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] >= low && values[i] <= high)) return rejectEntry(list, i, values[i], range);
    if (i > 0 && !(values[i] > values[i - 1])) return rejectEntry(list, i, values[i], "exceed the entry before");
  }
  return {};
}

}  // namespace

Result<void> validate(const SpectrumTable& table) {
  PELAGIC_CHECK(checkCount("frequency", table.frequency.size(), 2, 4096));
  if (!table.direction.empty()) PELAGIC_CHECK(checkCount("direction", table.direction.size(), 3, 720));
  const std::size_t cells = table.frequency.size() * std::max<std::size_t>(1, table.direction.size());
  PELAGIC_CHECK(checkCount("density", table.density.size(), cells, cells));
  PELAGIC_CHECK(checkRising("frequency", table.frequency, 1e-3, 50, "lie in 1e-3 … 50 Hz"));
  PELAGIC_CHECK(checkRising("direction", table.direction, -kTwoPi, kTwoPi, "lie in -2 pi … 2 pi rad"));
  if (!table.direction.empty() && table.direction.back() - table.direction.front() >= kTwoPi - 1e-9) {
    return rejectEntry("direction", table.direction.size() - 1, table.direction.back(),
                       "be less than a turn from the first");
  }
  double largest = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    if (!(table.density[i] >= 0 && table.density[i] <= 1e6)) {
      return rejectEntry("density", i, table.density[i], "lie in 0 … 1e6");
    }
    largest = std::max(largest, table.density[i]);
  }
  if (largest == 0) return gpu::reject("SeaState::table.density is 0 everywhere, it must not be");
  return {};
}

double tableSpectrum(const SpectrumTable& table, double angularFrequency) noexcept {
  const Place place = placeOf(table, angularFrequency / kTwoPi);
  const double density = std::lerp(entryDensity(table, place.low), entryDensity(table, place.high), place.share);
  return place.tail * density / kTwoPi;
}

double tablePeak(const SpectrumTable& table) noexcept {
  std::size_t best = 0;
  for (std::size_t i = 1; i < table.frequency.size(); ++i) {
    if (entryDensity(table, i) > entryDensity(table, best)) best = i;
  }
  return kTwoPi * table.frequency[best];
}

double tableLongestPeak(const SpectrumTable& table) noexcept {
  const double largest = kTwoPi * tableSpectrum(table, tablePeak(table));
  const std::size_t last = table.frequency.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const double density = entryDensity(table, i);
    if (density >= 0.1 * largest && density >= entryDensity(table, i + 1)) return kTwoPi * table.frequency[i];
  }
  return kTwoPi * table.frequency[last];
}

double tableSpreading(const SpectrumTable& table, double angularFrequency, double direction) noexcept {
  const Place place = placeOf(table, angularFrequency / kTwoPi);
  const double total = std::lerp(entryDensity(table, place.low), entryDensity(table, place.high), place.share);
  if (!(total > 0)) return 1 / kTwoPi;
  const Place around = placeAround(table.direction, direction);
  const auto at = [&](std::size_t entry) {
    const double* density = table.density.data() + entry * table.direction.size();
    return std::lerp(density[around.low], density[around.high], around.share);
  };
  return std::lerp(at(place.low), at(place.high), place.share) / total;
}

}  // namespace pelagic
