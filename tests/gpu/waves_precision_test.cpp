/// What 16-bit maps cost: their error against 32-bit maps of the same sea, summed over cascades as a picture sums them.
#include <cmath>

#include "waves_support.hpp"

namespace {

/// Unit of a half's last place over its value, at most: 10 bits follow the first. Vulkan lets a device round to
/// nearest, half of this, or toward zero, as Mesa's software device does.
constexpr double kUnit = 0x1p-10;
constexpr std::uint32_t kSize = 64;
/// The smallest half.
constexpr double kSmallest = 0x1p-24;

class WavePrecisionTest : public support::WavesTest {};

/// Root mean square and largest size of differences.
struct Error {
  double squares = 0;
  double largest = 0;
  std::size_t count = 0;

  void add(double difference) {
    squares += difference * difference;
    largest = std::max(largest, std::abs(difference));
    ++count;
  }
  double rms() const { return std::sqrt(squares / static_cast<double>(count)); }
};

/// Texels of the cascades that lie over points strewn over the sea: a sum has one texel of each, at other places of
/// each patch.
std::size_t texelOf(std::size_t point, std::uint32_t cascade, std::size_t texels) {
  return (point * (2 * cascade + 1) * 2654435761u + cascade * 40503u) % texels;
}

TEST_F(WavePrecisionTest, HalfMapsStayWithinTheirErrorBudget) {
  for (const auto& sea : support::fiveSeas()) {
    pelagic::WavesInfo info;
    info.sea = sea;
    info.layout = pelagic::waveLayout(sea, 4, kSize).value();
    info.precision = pelagic::MapPrecision::single;
    auto single = create(info);
    info.precision = pelagic::MapPrecision::half;
    auto half = create(info);
    record(single, 3600);
    record(half, 3600);
    constexpr std::size_t kPoints = std::size_t{kSize} * kSize;
    std::vector<glm::dvec3> differences(kPoints, glm::dvec3(0));  // h, dh/dx, dh/dz
    std::vector<glm::dvec3> sizes(kPoints, glm::dvec3(0));        // sums of their absolute values
    Error variance;
    double slopes = 0;
    for (std::uint32_t c = 0; c < info.layout.count; ++c) {
      const auto exact = read(single.maps(), c);
      const auto rounded = read(half.maps(), c);
      for (std::size_t p = 0; p < kPoints; ++p) {
        const std::size_t at = texelOf(p, c, kPoints);
        const glm::dvec3 value(exact[0][at], exact[3][at], exact[4][at]);
        differences[p] += glm::dvec3(rounded[0][at], rounded[3][at], rounded[4][at]) - value;
        sizes[p] += glm::abs(value);
      }
      slopes += support::varianceOf(exact[3]) + support::varianceOf(exact[4]);
      // Mips: dh/dx's and dh/dz's variance within a texel, where there is some.
      for (std::uint32_t mip = 1; mip < single.maps().moments.mips; ++mip) {
        const auto a = common::readFloats(gpu(), single.maps().moments, mip, c);
        const auto b = common::readFloats(gpu(), half.maps().moments, mip, c);
        double total = 0, difference = 0;
        for (std::size_t i = 0; i < a.size(); i += 4) {
          total += static_cast<double>(a[i]) + static_cast<double>(a[i + 1]);
          difference += static_cast<double>(b[i]) + static_cast<double>(b[i + 1]);
        }
        // Beside the last step of the smallest halves, in which calm water's are counted.
        const double steps = static_cast<double>(a.size() / 2) * kSmallest / kUnit;
        if (total > 0) variance.add((difference - total) / (total + steps));
      }
    }
    Error height, slope;
    for (std::size_t p = 0; p < kPoints; ++p) {
      const glm::dvec3& difference = differences[p];
      height.add(difference.x);
      slope.add(difference.y);
      slope.add(difference.z);
      // Every cascade's value is rounded by itself, so the errors add.
      const glm::dvec3 bound = kUnit * sizes[p] + info.layout.count * kSmallest;
      for (int i = 0; i < 3; ++i) ASSERT_LE(std::abs(difference[i]), bound[i]) << "size " << sizes[p][i];
    }
    // An error that is even between 0 and a unit has a root mean square of unit/sqrt(3), less for the mantissas above
    // 1; the longest cascade holds nearly all of the height.
    const double rms = kUnit / std::sqrt(3);
    const double height1 = single.report().gridHeight / 4;
    const double slope1 = std::sqrt(slopes / 2);
    EXPECT_LT(height.rms(), rms * height1);
    EXPECT_LT(slope.rms(), rms * slope1);
    // Five standard deviations, for 6e4 Gaussian values.
    EXPECT_LT(height.largest, 5 * kUnit * height1);
    EXPECT_LT(slope.largest, 5 * kUnit * slope1);
    // A variance is the mean of squares of rounded slopes, two units, rounded once more.
    EXPECT_LT(variance.largest, 3 * kUnit);
    const std::string key = std::to_string(static_cast<int>(sea.windSpeed));
    RecordProperty("height_rms_over_hs_" + key, std::to_string(height.rms() / (4 * height1)));
    RecordProperty("height_largest_over_hs_" + key, std::to_string(height.largest / (4 * height1)));
    RecordProperty("slope_rms_over_rms_" + key, std::to_string(slope.rms() / slope1));
    RecordProperty("slope_largest_over_rms_" + key, std::to_string(slope.largest / slope1));
    RecordProperty("variance_largest_" + key, std::to_string(variance.largest));
  }
}

}  // namespace
