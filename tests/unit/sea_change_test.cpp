#include <gtest/gtest.h>

#include <cmath>
#include <pelagic/query.hpp>
#include <waves/sea_change.hpp>

namespace {

using namespace pelagic;

WavesInfo small(double wind, std::uint32_t count = 2) {
  WavesInfo info;
  info.sea.windSpeed = 14;
  info.layout = *waveLayout(info.sea, count, 64);
  info.sea.windSpeed = wind;
  return info;
}

SeaState blowing(double wind, double direction = 0) {
  SeaState sea;
  sea.windSpeed = wind;
  sea.windDirection = direction;
  return sea;
}

SeaQuery queryOf(const WavesInfo& info, double time = 0) {
  SeaQuery query = *SeaQuery::create(info);
  query.setTime(time);
  return query;
}

TEST(SeaChange, SharesGrowFromZeroToOneWithoutAJumpInSpeedOrAcceleration) {
  const SeaTransition transition{100, 20};
  EXPECT_EQ(shareAt(transition, 99).value, 0);
  EXPECT_EQ(shareAt(transition, 100).value, 0);
  EXPECT_DOUBLE_EQ(shareAt(transition, 110).value, 0.5);
  EXPECT_EQ(shareAt(transition, 120).value, 1);
  EXPECT_EQ(shareAt(transition, 1e9).value, 1);
  constexpr double kStep = 1e-4;
  for (double time = 100.001; time < 120; time += 0.37) {
    const Share now = shareAt(transition, time);
    const Share before = shareAt(transition, time - kStep);
    const Share after = shareAt(transition, time + kStep);
    EXPECT_NEAR(now.rate, (after.value - before.value) / (2 * kStep), 1e-6);
    EXPECT_NEAR(now.acceleration, (after.rate - before.rate) / (2 * kStep), 1e-6);
  }
  EXPECT_NEAR(shareAt(transition, 100.01).acceleration, 0, 1e-3);
  EXPECT_NEAR(shareAt(transition, 119.99).acceleration, 0, 1e-3);
}

TEST(SeaChange, IsTheOldSeaBeforeAndTheNewOneAfter) {
  SeaQuery changing = queryOf(small(5));
  ASSERT_TRUE(changing.setSea(blowing(14, 1), {100, 10}));
  const SeaQuery before = queryOf(small(5), 99);
  WavesInfo strong = small(5);
  strong.sea = blowing(14, 1);
  const SeaQuery after = queryOf(strong, 111);
  for (const glm::dvec2 p : {glm::dvec2(0, 0), glm::dvec2(13.7, -40), glm::dvec2(-1000, 777)}) {
    changing.setTime(99);
    EXPECT_EQ(changing.heightAt(p), before.heightAt(p));
    changing.setTime(111);
    EXPECT_EQ(changing.heightAt(p), after.heightAt(p));
    EXPECT_EQ(changing.at(p).velocity, after.at(p).velocity);
  }
}

/// The fastest that any of a row of points of the undisplaced plane rises or sinks between two frames [m/s].
double fastest(SeaQuery& query, double from, double to) {
  constexpr double kFrame = 1.0 / 60;
  std::vector<double> last;
  double most = 0;
  for (double time = from; time < to; time += kFrame) {
    query.setTime(time);
    for (std::size_t i = 0; i < 64; ++i) {
      const double height = query.heightAt({4.0 * static_cast<double>(i), 0.3 * static_cast<double>(i)});
      if (last.size() < 64) {
        last.push_back(height);
      } else {
        most = std::max(most, std::abs(height - last[i]) / kFrame);
        last[i] = height;
      }
    }
  }
  return most;
}

TEST(SeaChange, NoHeightMovesFasterThanTheStrongerSeaDoes) {
  SeaQuery steady = queryOf(small(14));
  const double allowed = fastest(steady, 20, 32);
  SeaQuery rising = queryOf(small(4));
  ASSERT_TRUE(rising.setSea(blowing(14), {22, 8}));
  EXPECT_LE(fastest(rising, 20, 32), 1.1 * allowed);
  SeaQuery falling = queryOf(small(14));
  ASSERT_TRUE(falling.setSea(blowing(4), {22, 8}));
  EXPECT_LE(fastest(falling, 20, 32), 1.1 * allowed);
  // What this would look like without a transition.
  SeaQuery jumping = queryOf(small(4), 25);
  const double low = jumping.heightAt({0, 0});
  ASSERT_TRUE(jumping.setSea(blowing(14)));
  EXPECT_GT(std::abs(jumping.heightAt({0, 0}) - low) * 60, 3 * allowed);
}

TEST(SeaChange, VelocityAndAccelerationAreThoseOfTheChangingHeight) {
  WavesInfo info = small(4);
  info.sea.choppiness = 0;  // so that a point stays over its place
  SeaQuery query = queryOf(info);
  SeaState strong = blowing(14);
  strong.choppiness = 0;
  ASSERT_TRUE(query.setSea(strong, {10, 4}));
  constexpr double kStep = 1e-2;
  for (const double time : {10.7, 11.9, 13.3}) {
    const glm::dvec2 p(3, 4);
    query.setTime(time - kStep);
    const SurfacePoint before = query.at(p);
    query.setTime(time + kStep);
    const SurfacePoint after = query.at(p);
    query.setTime(time);
    const SurfacePoint now = query.at(p);
    EXPECT_NEAR(now.velocity.y, (after.position.y - before.position.y) / (2 * kStep), 2e-4) << time;
    EXPECT_NEAR(now.acceleration.y, (after.velocity.y - before.velocity.y) / (2 * kStep), 2e-4) << time;
  }
}

TEST(SeaChange, ANewChangeStartsFromWhatIsThere) {
  // Depth bends the frequencies, so that the modes of both seas have turned by different angles.
  WavesInfo info = small(8);
  SeaState shallow = blowing(12, 0.5);
  shallow.depth = 6;
  shallow.choppiness = 0.6;
  SeaQuery query = queryOf(info);
  ASSERT_TRUE(query.setSea(shallow, {50, 10}));
  query.setTime(56);
  std::vector<SurfacePoint> there;
  const auto points = [](int i) { return glm::dvec2(7.0 * i, -3.0 * i); };
  for (int i = 0; i < 32; ++i) there.push_back(query.at(points(i)));
  ASSERT_TRUE(query.setSea(blowing(5, -1), {56, 10}));
  for (int i = 0; i < 32; ++i) {
    const SurfacePoint now = query.at(points(i));
    // Both seas' displacements share one choppiness from here on: close, not exact, where depth and choppiness changed.
    EXPECT_NEAR(now.position.y, there[static_cast<std::size_t>(i)].position.y, 0.04);
    EXPECT_NEAR(now.undisplaced.x, there[static_cast<std::size_t>(i)].undisplaced.x, 0.08);
  }
}

TEST(SeaChange, MomentsAreThoseOfTheMixedAmplitudes) {
  const WavesInfo info = small(4);
  const WavesInfo strong = small(14);
  SeaChange steady;
  steady.after = makeGridSea(info.sea, info);
  const SeaChange change = changeSea(steady, makeGridSea(strong.sea, info), {0, 10}, info);
  const SeaMoments weak = steady.after.moments, full = change.after.moments;
  EXPECT_EQ(change.momentsAt(0).elevation, weak.elevation);
  EXPECT_EQ(change.momentsAt(1).elevation, full.elevation);
  // Amplitudes of one random number add: with sigma of both seas known, no mixture is rougher than their mean
  // deviation.
  const double half = std::sqrt(change.momentsAt(0.5).elevation);
  EXPECT_LE(half, 0.5 * (std::sqrt(weak.elevation) + std::sqrt(full.elevation)) * 1.02);
  EXPECT_GE(half, 0.45 * std::sqrt(full.elevation));
  // From nothing, half the amplitude is a quarter of the variance, but for the scatter of the random numbers.
  SeaState calm = blowing(4);
  calm.octaveGain.fill(0);
  SeaChange still;
  still.after = makeGridSea(calm, info);
  const SeaChange rising = changeSea(still, makeGridSea(strong.sea, info), {0, 10}, info);
  EXPECT_NEAR(rising.momentsAt(0.5).slopes[1].x / full.slopes[1].x, 0.25, 0.02);
}

TEST(SeaChange, BadTransitionsAreNamed) {
  SeaQuery query = queryOf(small(5));
  EXPECT_EQ(query.setSea(blowing(8), {std::nan(""), 1}).error().message,
            "SeaTransition::start is nan, it must be finite");
  EXPECT_EQ(query.setSea(blowing(8), {0, -1}).error().message,
            "SeaTransition::seconds is -1, it must lie in 0 … 1e6 s");
}

}  // namespace
