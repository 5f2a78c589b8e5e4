#include "compare.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

/// Waves of light, the same on every machine.
golden::Picture sample(double gain = 1, double shift = 0) {
  golden::Picture picture{64, 48, {}};
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const double light = gain * (0.4 + 0.2 * std::sin(0.7 * (x + shift) + 0.3 * y + c));
        picture.rgb.push_back(static_cast<std::uint8_t>(std::lround(255 * std::sqrt(light))));
      }
    }
  }
  return picture;
}

TEST(GoldenCompare, TheSamePictureAgrees) { EXPECT_TRUE(golden::compare(sample(), sample()).empty()); }

TEST(GoldenCompare, RoundingIsForgiven) {
  golden::Picture rounded = sample();
  for (std::size_t i = 0; i < rounded.rgb.size(); i += 97)
    rounded.rgb[i] = static_cast<std::uint8_t>(rounded.rgb[i] ^ 1);
  EXPECT_TRUE(golden::compare(sample(), rounded).empty());
}

TEST(GoldenCompare, OnePercentOfLightIsSeen) { EXPECT_FALSE(golden::compare(sample(), sample(1.01)).empty()); }

TEST(GoldenCompare, AShiftIsSeen) { EXPECT_FALSE(golden::compare(sample(), sample(1, 0.5)).empty()); }

TEST(GoldenCompare, ABrokenBlockIsSeen) {
  golden::Picture broken = sample();
  for (std::uint32_t y = 16; y < 32; ++y) {
    for (std::uint32_t x = 16; x < 32; ++x) broken.rgb[(std::size_t{y} * broken.width + x) * 3] -= 2;
  }
  const auto findings = golden::compare(sample(), broken);
  ASSERT_FALSE(findings.empty());
  EXPECT_NE(findings.front().find("block at (16, 16)"), std::string::npos) << findings.front();
}

TEST(GoldenCompare, AnotherSizeIsSeen) {
  golden::Picture shorter = sample();
  shorter.height = 47;
  shorter.rgb.resize(shorter.rgb.size() - 64 * 3);
  EXPECT_FALSE(golden::compare(sample(), shorter).empty());
}

TEST(GoldenPicture, EncodesLightAndRejectsTheRest) {
  EXPECT_EQ(golden::encode(1, 1, {0, 1, 1e9f, 7}, 0).rgb, (std::vector<std::uint8_t>{0, 180, 255}));
  EXPECT_EQ(golden::encode(1, 1, {0, 0.25f, 0, 1}, 2).rgb, (std::vector<std::uint8_t>{0, 180, 0}));
  EXPECT_THROW(golden::encode(1, 1, {0, NAN, 0, 1}, 0), std::runtime_error);
  EXPECT_THROW(golden::encode(1, 1, {0, -1, 0, 1}, 0), std::runtime_error);
}

}  // namespace
