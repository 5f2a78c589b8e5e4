#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <waves/warp.hpp>

namespace {

using namespace pelagic;

WaveLayout defaultLayout() { return *waveLayout(SeaState{}); }

template <class Look>
void atRandomPlaces(int count, double reach, Look look) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-reach, reach);
  for (int i = 0; i < count; ++i) {
    const double x = place(random);
    look(glm::dvec2(x, place(random)));
  }
}

TEST(Warp, GradientsHaveTheDeviationAskedFor) {
  for (const double gradient : {0.01, 0.05, 0.1}) {
    const Warp warp(defaultLayout(), gradient);
    constexpr int kPlaces = 100000;
    glm::dmat2 squares(0);
    glm::dmat2 sum(0);
    atRandomPlaces(kPlaces, 1e6, [&](const glm::dvec2& p) {
      const glm::dmat2 slopes(warp.at(p).slopes);
      squares += glm::matrixCompMult(slopes, slopes);
      sum += slopes;
    });
    for (int i = 0; i < 4; ++i) {
      // Eight waves do not spread over the directions quite evenly.
      EXPECT_NEAR(std::sqrt(squares[i / 2][i % 2] / kPlaces) / gradient, 1, 0.1) << i;
      EXPECT_NEAR(sum[i / 2][i % 2] / kPlaces / gradient, 0, 0.02) << i;
    }
  }
}

TEST(Warp, SlopesAreDerivatives) {
  const Warp warp(defaultLayout(), 0.05);
  const auto shiftAt = [&](double x, double z) { return glm::dvec2(warp.at({x, z}).shift); };
  for (const double reach : {1e3, 1e7}) {
    atRandomPlaces(1000, reach, [&](const glm::dvec2& p) {
      constexpr double kStep = 5;  // the shift is in 32 bits
      const glm::dvec2 x = (shiftAt(p.x + kStep, p.y) - shiftAt(p.x - kStep, p.y)) / (2 * kStep);
      const glm::dvec2 z = (shiftAt(p.x, p.y + kStep) - shiftAt(p.x, p.y - kStep)) / (2 * kStep);
      const glm::dmat2 slopes(warp.at(p).slopes);
      for (int i = 0; i < 2; ++i) {
        EXPECT_NEAR(slopes[0][i], x[i], 5e-4);
        EXPECT_NEAR(slopes[1][i], z[i], 5e-4);
      }
    });
  }
}

TEST(Warp, IsOneToOne) {
  // The stretched area stays positive at the greatest gradient that is allowed, so that no water is seen twice.
  constexpr double kMost = 0.1;
  const Warp warp(defaultLayout(), kMost);
  atRandomPlaces(100000, 1e6, [&](const glm::dvec2& p) {
    const glm::dmat2 slopes(warp.at(p).slopes);
    EXPECT_GT(glm::determinant(glm::dmat2(1) + slopes), 0.2);
    // The larger singular value, from the invariants of the square.
    const glm::dmat2 square = glm::transpose(slopes) * slopes;
    const double half = 0.5 * (square[0][0] + square[1][1]);
    const double largest = std::sqrt(half + std::sqrt(std::max(0.0, half * half - glm::determinant(square))));
    EXPECT_LT(largest, kLargestStretch * kMost);
  });
}

TEST(Warp, StandsStillAtTheOrigin) {
  const Warp warp(defaultLayout(), 0.05);
  const LocalWarp origin = warp.at({0, 0});
  EXPECT_NEAR(glm::length(origin.shift), 0, 1e-4);
  // Where a hull is and as far as it is seen from a deck, waves are as in the patch.
  double worst = 0;
  for (int i = 0; i < 64; ++i) {
    const glm::mat2 slopes = warp.at({20 * std::cos(0.1 * i), 20 * std::sin(0.1 * i)}).slopes;
    for (int j = 0; j < 4; ++j) worst = std::max(worst, std::abs(static_cast<double>(slopes[j / 2][j % 2])));
  }
  EXPECT_LT(worst, 0.01);
}

TEST(Warp, NoneLeavesPlacesWhereTheyAre) {
  const LocalWarp none = Warp(defaultLayout(), 0).at({123, -4567});
  EXPECT_EQ(none.shift, glm::vec2(0));
  EXPECT_EQ(none.slopes, glm::mat2(0));
  EXPECT_EQ(none.shiftAt({5, 6}), glm::vec2(0));
}

TEST(Warp, ShadersAreToldThePhasesOfTheirOrigin) {
  // Where a shader's origin lies makes no difference: the phase there and the turns from there add up.
  const Warp warp(defaultLayout(), 0.05);
  const shader::WaveWarp here = warp.relativeTo({1e7, -2e6});
  const shader::WaveWarp there = warp.relativeTo({1e7 + 300, -2e6 + 70});
  for (int i = 0; i < 8; ++i) {
    const int group = i / 4;
    const int lane = i % 4;
    const float turns = here.phase[group][lane] + here.alongX[group][lane] * 300 + here.alongZ[group][lane] * 70 -
                        there.phase[group][lane];
    EXPECT_NEAR(turns - std::round(turns), 0, 1e-6) << i;
    EXPECT_LE(std::abs(here.phase[group][lane]), 0.5f) << i;
  }
}

}  // namespace
