#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <pelagic/query.hpp>
#include <random>

#include <waves/warp.hpp>

#include "lattice.hpp"

namespace {

using namespace pelagic;
constexpr double kTwoPi = 2 * std::numbers::pi;

WavesInfo infoOf(const SeaState& sea, std::uint32_t count = 2, std::uint32_t size = 64) {
  WavesInfo info;
  info.sea = sea;
  info.layout = *waveLayout(sea, count, size);
  return info;
}

/// (Dx, h, Dz) by the sum of the modes in double precision, with the quantised frequencies.
glm::dvec3 directSum(const WavesInfo& info, std::uint32_t cascade, const glm::dvec2& p, double time) {
  const CascadeModes modes = makeModes(info.sea, info.layout, cascade, info.loopPeriod);
  const int n = static_cast<int>(info.layout.size);
  const double dk = kTwoPi / info.layout.cascades[cascade].length;
  glm::dvec3 sum(0);
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const auto index = static_cast<std::size_t>(row * n + column);
      if (modes.constants[index].cycles == 0) continue;
      const glm::dvec2 k = dk * glm::dvec2(column < n / 2 ? column : column - n, row < n / 2 ? row : row - n);
      const glm::dvec4 a(modes.amplitude[index]);
      const double turns = std::fmod(modes.constants[index].cycles * std::fmod(time, info.loopPeriod), info.loopPeriod);
      const auto e = std::polar(1.0, kTwoPi * turns / info.loopPeriod);
      const std::complex<double> h = std::complex(a.x, a.y) * std::conj(e) + std::complex(a.z, a.w) * e;
      const std::complex<double> wave = h * std::polar(1.0, glm::dot(k, p));
      const glm::dvec2 chop(modes.constants[index].chop);
      const std::complex<double> moved = std::complex(0.0, 1.0) * std::complex(chop.x, chop.y) * wave;
      sum += glm::dvec3((k.x * moved).real(), wave.real(), (k.y * moved).real());
    }
  }
  return sum;
}

TEST(Query, LatticeIsTheSumOfTheModesAtAnyTime) {
  SeaState sea;
  sea.windSpeed = 12;
  sea.windDirection = 0.6;
  sea.asymmetry = 1.3;
  WavesInfo info = infoOf(sea);
  for (const double loop : {4194304.0, 977.0}) {
    info.loopPeriod = loop;
    for (const double time : {0.0, 3600.25, 86400.0, 2592000.5, -17.0}) {
      for (std::uint32_t c = 0; c < 2; ++c) {
        const CpuLattice lattice = unit::latticeOf(info, c, time);
        for (const glm::uvec2 at : {glm::uvec2(0, 0), glm::uvec2(7, 33), glm::uvec2(63, 12)}) {
          const glm::dvec3 expected = directSum(info, c, glm::dvec2(at) * info.layout.cascades[c].length / 64.0, time);
          const glm::vec4 texel = lattice.texels().displacement[at.y * 64 + at.x];
          for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(static_cast<double>(texel[i]), expected[i], 2e-5) << "time " << time << " channel " << i;
          }
        }
      }
    }
  }
}

TEST(Query, GradientsAndMotionAreDerivatives) {
  SeaState sea;
  sea.windSpeed = 10;
  sea.asymmetry = 1;
  const WavesInfo info = infoOf(sea, 1);
  const double time = 41;
  const glm::uvec2 at(20, 45);
  const std::size_t index = at.y * 64 + at.x;
  const double cell = info.layout.cascades[0].length / 64;
  const glm::dvec2 p = glm::dvec2(at) * cell;
  const CpuLattice lattice = unit::latticeOf(info, 0, time);
  constexpr double kStep = 1e-3;
  const auto sum = [&](double x, double z, double t) { return directSum(info, 0, p + glm::dvec2(x, z), time + t); };
  const glm::dvec3 alongX = (sum(kStep, 0, 0) - sum(-kStep, 0, 0)) / (2 * kStep);
  const glm::dvec3 alongZ = (sum(0, kStep, 0) - sum(0, -kStep, 0)) / (2 * kStep);
  const glm::vec4 gradient = lattice.texels().gradient[index];
  EXPECT_NEAR(gradient.x, alongX.y, 1e-5);
  EXPECT_NEAR(gradient.y, alongZ.y, 1e-5);
  EXPECT_NEAR(gradient.z, alongX.x, 1e-5);
  EXPECT_NEAR(gradient.w, alongZ.z, 1e-5);
  EXPECT_NEAR(lattice.texels().displacement[index].w, alongX.z, 1e-5);
  const glm::dvec3 velocity = (sum(0, 0, kStep) - sum(0, 0, -kStep)) / (2 * kStep);
  constexpr double kWide = 0.02;
  const glm::dvec3 acceleration = (sum(0, 0, kWide) - 2.0 * sum(0, 0, 0) + sum(0, 0, -kWide)) / (kWide * kWide);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(lattice.texels().velocity[index][i], velocity[i], 1e-4) << i;
    EXPECT_NEAR(lattice.texels().acceleration[index][i], acceleration[i], 2e-3) << i;
  }
}

glm::dvec2 randomPoint(std::mt19937& random, double reach) {
  std::uniform_real_distribution<double> place(-reach, reach);
  const double x = place(random);
  return {x, place(random)};
}

TEST(Query, ThePointIsTheWaterThatIsDisplacedThere) {
  SeaState sea;
  sea.windSpeed = 8;
  const WavesInfo info = infoOf(sea, 2, 128);
  SeaQuery query = *SeaQuery::create(info, 1);
  query.setTime(100);
  std::vector<CpuLattice> lattices;
  for (std::uint32_t c = 0; c < 2; ++c) lattices.push_back(unit::latticeOf(info, c, 100, kTwoPi));
  const Warp warp(info.layout, info.warp);
  std::mt19937 random(5);
  int missed = 0;
  double variance = 0;
  double bent = 0;
  constexpr int kPoints = 20000;
  for (int i = 0; i < kPoints; ++i) {
    const glm::dvec2 point = randomPoint(random, i % 2 ? 1e3 : 1e7);
    const SurfacePoint at = query.at(point);
    const auto displaced = [&](const glm::vec2& shift) {
      glm::dvec4 sum(0);
      for (const CpuLattice& lattice : lattices) {
        const LatticePlace place = lattice.placeOf(at.undisplaced + glm::dvec2(shift));
        sum += glm::dvec4(place.value(lattice.texels().displacement));
      }
      return sum;
    };
    const glm::dvec4 d = displaced(warp.at(point).shiftAt(glm::vec2(at.undisplaced - point)));
    bent = std::max(bent, std::abs(d.y - displaced(warp.at(at.undisplaced).shift).y));
    missed += glm::length(at.undisplaced + glm::dvec2(d.x, d.z) - point) > 1e-5;
    EXPECT_NEAR(at.position.y, d.y, 1e-5);
    EXPECT_EQ(query.heightAt(point), at.position.y);
    double together = 0;
    query.heightsAt({&point, 1}, {&together, 1});
    EXPECT_EQ(together, at.position.y);
    EXPECT_EQ(at.position.x, point.x);
    EXPECT_EQ(at.position.z, point.y);
    EXPECT_NEAR(glm::length(at.normal), 1, 1e-12);
    variance += at.position.y * at.position.y;
  }
  // Where crests fold, none of Newton's steps may meet; that is less than a thousandth of a sea of 8 m/s.
  EXPECT_LE(missed, kPoints / 1000);
  EXPECT_NEAR(4 * std::sqrt(variance / kPoints) / significantWaveHeight(sea), 1, 0.1);
  // The warp is as good as linear over what the water is displaced.
  EXPECT_LT(bent, 1e-4 * significantWaveHeight(sea));
}

TEST(Query, ManyHeightsAreThoseOfThePointsOneByOne) {
  SeaQuery query = *SeaQuery::create(infoOf(SeaState{}), 1);
  query.setTime(3);
  std::mt19937 random(5);
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 1000; ++i) points.push_back(randomPoint(random, 1e4));
  points[17].x = std::nan("");
  points[40].y = 1e30;
  std::vector<double> heights(points.size());
  query.heightsAt(points, heights);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double alone = query.heightAt(points[i]);
    EXPECT_TRUE(heights[i] == alone || (std::isnan(heights[i]) && std::isnan(alone))) << i;
  }
  // As many as both hold.
  std::vector<double> few(37, 0.0);
  query.heightsAt(points, few);
  EXPECT_EQ(few.back(), heights[36]);
  std::vector<double> many(points.size() + 1, -7.0);
  query.heightsAt(points, many);
  EXPECT_EQ(many.back(), -7);
}

TEST(Query, NormalsBelongToTheDisplacedSurface) {
  SeaState sea;
  sea.windSpeed = 9;
  SeaQuery query = *SeaQuery::create(infoOf(sea, 1, 256), 22);  // some 20 cells a wave
  std::mt19937 random(7);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec2 p = randomPoint(random, 500);
    const glm::dvec3 normal = query.at(p).normal;
    constexpr double kStep = 0.5;
    const double x =
        (query.heightAt(p + glm::dvec2(kStep, 0)) - query.heightAt(p - glm::dvec2(kStep, 0))) / (2 * kStep);
    const double z =
        (query.heightAt(p + glm::dvec2(0, kStep)) - query.heightAt(p - glm::dvec2(0, kStep))) / (2 * kStep);
    EXPECT_NEAR(-normal.x / normal.y, x, 0.02);
    EXPECT_NEAR(-normal.z / normal.y, z, 0.02);
  }
}

TEST(Query, WavesRunWithTheWindAndWaterCirclesForwardOnCrests) {
  SeaState sea;
  sea.windSpeed = 0.5;
  sea.swell.push_back({2, 10, 0, 200});
  sea.choppiness = 1;
  const WavesInfo info = infoOf(sea, 1, 128);
  SeaQuery query = *SeaQuery::create(info, 20);
  const double speed = kGravity * 10 / kTwoPi;
  double ahead = 0, behind = 0, forward = 0;
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i) {
    const SurfacePoint now = query.at(randomPoint(random, 1e3));
    forward += now.position.y * now.velocity.x;
  }
  EXPECT_GT(forward, 0);  // on a crest of a wave toward +x the water moves toward +x
  std::vector<glm::dvec2> points;
  std::vector<double> heights;
  for (int i = 0; i < 500; ++i) {
    points.push_back(randomPoint(random, 1e3));
    heights.push_back(query.heightAt(points.back()));
  }
  query.setTime(2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ahead += heights[i] * query.heightAt(points[i] + glm::dvec2(2 * speed, 0));
    behind += heights[i] * query.heightAt(points[i] - glm::dvec2(2 * speed, 0));
  }
  EXPECT_GT(ahead, 0.2 * 500);  // of m0 = 0.25 m^2
  EXPECT_LT(behind, 0.5 * ahead);
}

void expectFirstHits(const SeaState& sea) {
  SeaQuery query = *SeaQuery::create(infoOf(sea, 2, 128), 1);
  query.setTime(12);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    const bool below = i % 3 == 0;
    const glm::dvec2 p = randomPoint(random, 300);
    const glm::dvec3 origin(p.x, below ? -12 : 10 + 5 * unit(random), p.y);
    const glm::dvec3 direction(unit(random), (below ? 0.4 : -0.4) + 0.3 * unit(random), unit(random));
    const auto hit = query.intersect(origin, direction, 2000);
    if (!hit) continue;
    ++hits;
    const glm::dvec3 along = hit->position - origin;
    const double t = glm::length(along);
    EXPECT_NEAR(glm::length(glm::cross(along, glm::normalize(direction))), 0, 2e-4);
    for (int s = 0; s < 400; ++s) {
      const glm::dvec3 before = origin + along * (0.999 * s / 400);
      const double gap = before.y - query.heightAt({before.x, before.z});
      EXPECT_GT(below ? -gap : gap, -0.02)
          << "ray " << i << " passes " << gap << " m through at " << s << "/400 of " << t;
    }
  }
  EXPECT_GT(hits, 250);
}

TEST(Query, RaysMeetTheSurfaceWhereItIsFirst) {
  SeaState sea;
  sea.windSpeed = 12;
  expectFirstHits(sea);
  // The steepest faces: a gale's that lean as far as they may.
  sea.windSpeed = 20;
  sea.asymmetry = 2;
  expectFirstHits(sea);
}

TEST(Query, RaysThatMeetNothingAreNone) {
  SeaState sea;
  sea.windSpeed = 12;
  const SeaQuery query = *SeaQuery::create(infoOf(sea, 2, 128), 1);
  EXPECT_FALSE(query.intersect({0, 20, 0}, {1, 0.1, 0}, 1e5));
  EXPECT_FALSE(query.intersect({0, 50, 0}, {0, -1, 0}, 10));
  EXPECT_TRUE(query.intersect({0, 50, 0}, {0, -1, 0}, 100));
  EXPECT_FALSE(query.intersect({0, 50, 0}, {0, 0, 0}, 100));
  EXPECT_FALSE(query.intersect({std::nan(""), 50, 0}, {0, -1, 0}, 100));
}

TEST(Query, AnyTimeInAnyOrderGivesTheSameBitsAndLoopsClose) {
  WavesInfo info = infoOf(SeaState{});
  info.loopPeriod = 64;
  SeaQuery query = *SeaQuery::create(info);
  query.setTime(5);
  const SurfacePoint first = query.at({12, -7});
  query.setTime(1e9);
  query.setTime(5 + 64 * 1000.0);
  EXPECT_EQ(query.at({12, -7}).position.y, first.position.y);
  query.setTime(5 - 64);
  EXPECT_EQ(query.at({12, -7}).position.y, first.position.y);
  ASSERT_TRUE(query.setSea(SeaState{}));
  EXPECT_EQ(query.at({12, -7}).velocity.x, first.velocity.x);
  query.setTime(std::nan(""));
  EXPECT_EQ(query.at({12, -7}).position.y, first.position.y);
}

TEST(Query, BadInputIsNamedOrDefined) {
  const WavesInfo info = infoOf(SeaState{});
  EXPECT_EQ(SeaQuery::create(info, -1).error().message,
            "the shortest wavelength is -1.000000 m, it must lie in 0 … 10000 m");
  EXPECT_FALSE(SeaQuery::create(info, std::nan("")));
  WavesInfo broken = info;
  broken.layout.size = 100;
  EXPECT_FALSE(SeaQuery::create(broken));
  SeaQuery query = *SeaQuery::create(info);
  EXPECT_TRUE(std::isnan(query.heightAt({std::nan(""), 0})));
  EXPECT_TRUE(std::isnan(query.at({0, 1e30}).position.y));
  SeaState bad;
  bad.windSpeed = -1;
  const double before = query.heightAt({1, 2});
  EXPECT_FALSE(query.setSea(bad));
  EXPECT_EQ(query.heightAt({1, 2}), before);
  // A cut longer than every wave leaves still water.
  SeaQuery still = *SeaQuery::create(info, 9999);
  EXPECT_EQ(still.heightAt({3, 4}), 0);
  EXPECT_EQ(still.at({3, 4}).normal, glm::dvec3(0, 1, 0));
}

}  // namespace
