/// Points on the sea: the GPU against the CPU.
#include <cmath>
#include <ostream>
#include <pelagic/point_query.hpp>
#include <random>

#include "waves_support.hpp"

namespace {

using pelagic::MapPrecision;
using pelagic::SurfacePoint;

constexpr double kMonth = 86400 * 30 + 0.3;  // [s]

class PointQueryTest : public support::WavesTest {
 protected:
  pelagic::PointQuery queryOf(const pelagic::Waves& waves, const pelagic::PointQueryInfo& info) {
    auto query = pelagic::PointQuery::create(device(), waves, info);
    if (!query) throw std::runtime_error(query.error().message);
    return std::move(*query);
  }
  std::vector<SurfacePoint> ask(pelagic::PointQuery& query, std::span<const glm::dvec2> points) {
    std::uint64_t ticket = 0;
    gpu().run([&](vk::CommandBuffer commands) { ticket = query.record(commands, points).value(); });
    std::vector<SurfacePoint> results(points.size());
    EXPECT_TRUE(query.read(ticket, results));
    return results;
  }
  std::string refusal(const pelagic::Waves& waves, const pelagic::PointQueryInfo& info) {
    return pelagic::PointQuery::create(device(), waves, info).error().message;
  }
};

struct Sea {
  const char* name;
  pelagic::SeaState state;
};

/// What the names of the tests say.
void PrintTo(const Sea& sea, std::ostream* out) { *out << sea.name; }

std::vector<Sea> fiveSeas() {
  std::vector<Sea> seas{{"calm", {}}, {"default", {}}, {"gale", {}}, {"swell", {}}, {"shallow", {}}};
  seas[0].state.windSpeed = 2;
  seas[2].state.windSpeed = 20;
  seas[2].state.windDirection = 2;
  seas[3].state.windSpeed = 4;
  seas[3].state.spectrum = pelagic::Spectrum::elfouhaily;
  seas[3].state.swell.push_back({3, 13, 1, 40});
  seas[4].state.windSpeed = 12;
  seas[4].state.depth = 6;
  seas[4].state.spectrum = pelagic::Spectrum::tma;
  return seas;
}

std::vector<glm::dvec2> randomPoints(std::size_t count, const glm::dvec2& origin, double reach) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(-reach, reach);
  std::vector<glm::dvec2> points(count);
  for (glm::dvec2& point : points) {
    point.x = origin.x + place(random);
    point.y = origin.y + place(random);
  }
  return points;
}

/// How far the GPU's answers are from the CPU's.
struct Difference {
  double height = 0, undisplaced = 0, normal = 0;  ///< The largest [m], [m], [1].
  double velocity = 0, acceleration = 0;           ///< |a - b| / |b| over all points.
};

Difference differenceOf(const pelagic::SeaQuery& cpu, std::span<const glm::dvec2> points,
                        std::span<const SurfacePoint> found) {
  Difference worst;
  glm::dvec2 apart(0), size(0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint at = cpu.at(points[i]);
    const SurfacePoint& on = found[i];
    EXPECT_EQ(on.position.x, points[i].x);
    EXPECT_EQ(on.position.z, points[i].y);
    worst.height = std::max(worst.height, std::abs(at.position.y - on.position.y));
    worst.undisplaced = std::max(worst.undisplaced, glm::length(at.undisplaced - on.undisplaced));
    worst.normal = std::max(worst.normal, glm::length(at.normal - on.normal));
    const auto square = [](const glm::dvec3& v) { return glm::dot(v, v); };
    apart += glm::dvec2(square(at.velocity - on.velocity), square(at.acceleration - on.acceleration));
    size += glm::dvec2(square(at.velocity), square(at.acceleration));
  }
  worst.velocity = std::sqrt(apart.x / size.x);
  worst.acceleration = std::sqrt(apart.y / size.y);
  return worst;
}

class PointQuerySeas : public PointQueryTest, public testing::WithParamInterface<Sea> {
 protected:
  /// 1e5 points far out and after a month.
  Difference differences(MapPrecision precision, double& height) {
    pelagic::WavesInfo info;
    info.sea = GetParam().state;
    info.layout = *pelagic::waveLayout(info.sea, 4, precision == MapPrecision::single ? 256 : 128);
    info.precision = precision;
    pelagic::Waves waves = create(info);
    pelagic::SeaQuery cpu = *pelagic::SeaQuery::create(info);
    record(waves, kMonth);
    cpu.setTime(kMonth);
    height = waves.report().gridHeight;
    const auto points = randomPoints(100000, {1e7, -2e6}, 5e3);
    pelagic::PointQuery query = queryOf(waves, {100000, 1});
    return differenceOf(cpu, points, ask(query, points));
  }
};

INSTANTIATE_TEST_SUITE_P(Seas, PointQuerySeas, testing::ValuesIn(fiveSeas()),
                         [](const auto& sea) { return std::string(sea.param.name); });

// The bounds are those of point_query.hpp.
TEST_P(PointQuerySeas, SinglePrecisionAgreesWithTheCpu) {
  double height = 0;
  const Difference worst = differences(MapPrecision::single, height);
  EXPECT_LE(worst.height, 1e-4 * height);
  EXPECT_LE(worst.undisplaced, 1e-3 * height);
  EXPECT_LE(worst.normal, 1e-3);
  EXPECT_LE(worst.velocity, 1e-4);
  EXPECT_LE(worst.acceleration, 1e-3);
  RecordProperty("height", std::to_string(worst.height / height));
}

TEST_P(PointQuerySeas, HalfPrecisionAgreesWithTheCpu) {
  double height = 0;
  const Difference worst = differences(MapPrecision::half, height);
  EXPECT_LE(worst.height, 1e-3 * height);
  EXPECT_LE(worst.normal, 0.05);
  EXPECT_LE(worst.velocity, 1e-3);
  EXPECT_LE(worst.acceleration, 2e-2);
  RecordProperty("height", std::to_string(worst.height / height));
}

TEST_F(PointQueryTest, SteepCrestsAreTheSameSheet) {
  // Twice the physical choppiness in a gale, and waves down to some centimetres: crests fold.
  auto info = support::wavesInfo(256, 4, 10);
  info.sea.windSpeed = 20;
  info.sea.choppiness = 2;
  pelagic::Waves waves = create(info);
  pelagic::SeaQuery cpu = *pelagic::SeaQuery::create(info);
  record(waves, 7);
  cpu.setTime(7);
  const auto points = randomPoints(100000, {}, 2e3);
  pelagic::PointQuery query = queryOf(waves, {100000, 1, false});
  const auto found = ask(query, points);
  int apart = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    apart += std::abs(cpu.heightAt(points[i]) - found[i].position.y) > 1e-4 * waves.report().gridHeight;
  }
  // A place within the rounding of a fold's edge may be given either sheet.
  EXPECT_LE(apart, 2);
}

TEST_F(PointQueryTest, AgreesWhileTheSeaChanges) {
  const auto info = support::wavesInfo(64, 8, 6);
  pelagic::SeaState other;
  other.windSpeed = 14;
  other.windDirection = 1;
  other.depth = 15;
  pelagic::Waves waves = create(info);
  pelagic::SeaQuery cpu = *pelagic::SeaQuery::create(info);
  pelagic::PointQuery query = queryOf(waves, {2000, 2});
  const auto points = randomPoints(2000, {}, 500);
  ASSERT_TRUE(waves.setSea(other, {100, 4}));
  ASSERT_TRUE(cpu.setSea(other, {100, 4}));
  for (const double time : {99.0, 101.0, 102.2, 103.9, 105.0}) {
    record(waves, time);
    cpu.setTime(time);
    const Difference worst = differenceOf(cpu, points, ask(query, points));
    EXPECT_LE(worst.height, 1e-4 * waves.report().gridHeight) << time;
    EXPECT_LE(worst.velocity, 1e-4) << time;
    EXPECT_LE(worst.acceleration, 1e-3) << time;
  }
}

TEST_F(PointQueryTest, AgreesUnderAMapOfGains) {
  pelagic::WavesInfo info;
  info.sea.windSpeed = 11;
  info.layout = *pelagic::waveLayout(info.sea, 3, 64);
  info.precision = MapPrecision::single;
  info.gain = {{4990, -30}, 25, 4, 3, 3, {}};
  for (int i = 0; i < 36; ++i) info.gain.gains.push_back(static_cast<float>(std::fmod(0.37 * i, 1.6)));
  auto waves = create(info);
  record(waves, 50);
  auto query = queryOf(waves, {2000, 2, true});
  auto cpu = *pelagic::SeaQuery::create(info);
  cpu.setTime(50);
  const auto points = randomPoints(2000, {5030, 0}, 90);
  const auto results = ask(query, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint expected = cpu.at(points[i]);
    ASSERT_NEAR(results[i].position.y, expected.position.y, 1e-4 * waves.report().gridHeight);
    ASSERT_LT(glm::length(results[i].normal - expected.normal), 2e-3);
    ASSERT_LT(glm::length(results[i].velocity - expected.velocity), 1e-3);
  }
  for (float& gain : info.gain.gains) gain = 1.6f - gain;
  ASSERT_TRUE(waves.setGain(info.gain));
  ASSERT_TRUE(cpu.setGain(info.gain));
  record(waves, 50);
  const auto changed = ask(query, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_NEAR(changed[i].position.y, cpu.heightAt(points[i]), 1e-4 * waves.report().gridHeight);
  }
  const pelagic::SurfaceRay ray{{5000, 20, 3}, {0.4, -1, 0.2}, 60};
  std::uint64_t ticket = 0;
  gpu().run([&](vk::CommandBuffer commands) { ticket = query.recordRays(commands, {&ray, 1}).value(); });
  std::optional<SurfacePoint> hit;
  ASSERT_TRUE(query.readRays(ticket, {&hit, 1}));
  const auto expected = cpu.intersect(ray.origin, ray.direction, ray.reach);
  ASSERT_TRUE(hit && expected);
  EXPECT_LT(glm::length(hit->position - expected->position), 0.01);
}

TEST_F(PointQueryTest, RaysMeetTheSeaWhereTheCpuSaysSo) {
  auto info = support::wavesInfo(128, 3, 12);
  info.sea.asymmetry = 2;  // the steepest faces
  pelagic::Waves waves = create(info);
  pelagic::SeaQuery cpu = *pelagic::SeaQuery::create(info);
  record(waves, 12);
  cpu.setTime(12);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<pelagic::SurfaceRay> rays(1000);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool below = i % 3 == 0;
    pelagic::SurfaceRay& ray = rays[i];
    ray.origin = {1e6 + 300 * unit(random), below ? -12 : 10 + 9.9 * unit(random), 300 * unit(random)};
    ray.direction = {unit(random), (below ? 0.4 : -0.4) + 0.45 * unit(random), unit(random)};
    ray.reach = 200;
  }
  rays[0].origin.y = 4e5;  // from a satellite
  rays[0].direction = {0.1, -3, 0.2};
  rays[0].reach = 1e6;
  rays[1].direction = {0, 0, 0};
  rays[2].origin.x = std::nan("");
  rays[3].reach = -1;
  rays[4].direction = {0, 1, 0};
  rays[4].origin.y = 20;
  pelagic::PointQuery query = queryOf(waves, {1000, 1});
  std::uint64_t ticket = 0;
  gpu().run([&](vk::CommandBuffer commands) { ticket = query.recordRays(commands, rays).value(); });
  std::vector<std::optional<SurfacePoint>> found(rays.size());
  ASSERT_TRUE(query.readRays(ticket, found));
  int hits = 0, others = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto expected = cpu.intersect(rays[i].origin, rays[i].direction, rays[i].reach);
    hits += expected.has_value();
    const bool same = expected.has_value() == found[i].has_value() &&
                      (!expected || glm::length(expected->position - found[i]->position) < 0.01);
    others += !same;
    if (!found[i]) continue;
    const SurfacePoint below = cpu.at({found[i]->position.x, found[i]->position.z});
    EXPECT_NEAR(found[i]->position.y, below.position.y, 1e-4 * waves.report().gridHeight) << i;
    EXPECT_LT(glm::length(found[i]->velocity - below.velocity), 1e-3) << i;
    const glm::dvec3 along = found[i]->position - rays[i].origin;
    EXPECT_LT(glm::length(glm::cross(along, glm::normalize(rays[i].direction))), i == 0 ? 1e-2 : 1e-3) << i;
  }
  EXPECT_GT(hits, 700);
  EXPECT_LE(others, 2);  // those that graze a crest
  EXPECT_TRUE(found[0]);
  for (int i = 1; i < 5; ++i) EXPECT_FALSE(found[static_cast<std::size_t>(i)]) << i;
}

TEST_F(PointQueryTest, TicketsAreGoodForTheCallsInFlight) {
  pelagic::Waves waves = create(support::wavesInfo(64, 2));
  pelagic::SeaQuery cpu = *pelagic::SeaQuery::create(support::wavesInfo(64, 2));
  pelagic::PointQuery query = queryOf(waves, {8, 3});
  const auto points = randomPoints(8, {}, 100);
  const std::vector<pelagic::SurfaceRay> rays(2, {{3, 10, 4}, {0, -1, 0}, 50});
  std::vector<std::uint64_t> tickets;
  // Two frames in one command buffer, then one more: five calls.
  gpu().run([&](vk::CommandBuffer commands) {
    for (const double time : {1.0, 2.0}) {
      waves.record(commands, time);
      tickets.push_back(query.record(commands, points).value());
      tickets.push_back(query.recordRays(commands, rays).value());
    }
  });
  EXPECT_EQ(query.read(tickets[0], {}).error().message,
            "the ticket 1 is too old: 3 more calls were recorded, PointQueryInfo::callsInFlight is 3");
  std::vector<std::optional<SurfacePoint>> hits(2);
  std::vector<SurfacePoint> results(8);
  pelagic::PointQuery moved = std::move(query);
  for (const auto& [ticket, time] : {std::pair(tickets[1], 1.0), std::pair(tickets[3], 2.0)}) {
    cpu.setTime(time);
    ASSERT_TRUE(moved.readRays(ticket, hits));
    EXPECT_NEAR(hits[1].value().position.y, cpu.heightAt({3, 4}), 1e-4);
  }
  for (int again = 0; again < 2; ++again) {
    ASSERT_TRUE(moved.read(tickets[2], results));
    EXPECT_LE(differenceOf(cpu, points, results).velocity, 1e-4);
  }
  EXPECT_EQ(moved.read(tickets[1], results).error().message, "the ticket 2 is of rays");
  EXPECT_EQ(moved.readRays(tickets[2], hits).error().message, "the ticket 3 is of points");
  EXPECT_EQ(moved.read(tickets[2], std::span(results).first(5)).error().message,
            "the ticket 3 has 8 results, there is room for 5");
  EXPECT_EQ(moved.read(0, results).error().message, "the ticket 0 was never given");
  EXPECT_EQ(moved.read(5, results).error().message, "the ticket 5 was never given");
}

TEST_F(PointQueryTest, WithoutMotionHeightsAreTheSame) {
  pelagic::Waves waves = create(support::wavesInfo(64, 2));
  pelagic::PointQuery whole = queryOf(waves, {100, 1});
  pelagic::PointQuery still = queryOf(waves, {100, 1, false});
  record(waves, 3);
  const auto points = randomPoints(100, {}, 100);
  const auto a = ask(whole, points);
  const auto b = ask(still, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(a[i].position.y, b[i].position.y);
    EXPECT_NE(a[i].velocity.y, 0);
    EXPECT_EQ(b[i].velocity, glm::dvec3(0));
    EXPECT_EQ(b[i].acceleration, glm::dvec3(0));
  }
  EXPECT_TRUE(ask(whole, {}).empty());
}

TEST_F(PointQueryTest, BadInputIsNamedOrDefined) {
  pelagic::Waves waves = create(support::wavesInfo(64, 1));
  EXPECT_EQ(refusal(waves, {0, 1}), "PointQueryInfo::capacity is 0, it must lie in 1 … 1000000");
  EXPECT_EQ(refusal(waves, {1000001, 1}), "PointQueryInfo::capacity is 1000001, it must lie in 1 … 1000000");
  EXPECT_EQ(refusal(waves, {1, 0}), "PointQueryInfo::callsInFlight is 0, it must lie in 1 … 16");
  EXPECT_EQ(refusal(waves, {1, 17}), "PointQueryInfo::callsInFlight is 17, it must lie in 1 … 16");
  pelagic::PointQuery query = queryOf(waves, {3, 1});
  std::vector<glm::dvec2> points{{std::nan(""), 0}, {0, 2e9}, {1, 2}};
  gpu().run([&](vk::CommandBuffer commands) {
    EXPECT_EQ(query.record(commands, points).error().message,
              "points of the sea are asked for before Waves::record() was called");
    waves.record(commands, 0);
    const std::vector<glm::dvec2> many(4);
    EXPECT_EQ(query.record(commands, many).error().message, "4 points are asked for, PointQueryInfo::capacity is 3");
  });
  const auto found = ask(query, points);
  EXPECT_TRUE(std::isnan(found[0].position.y));
  EXPECT_TRUE(std::isnan(found[1].position.y));
  EXPECT_EQ(found[1].normal, glm::dvec3(0, 1, 0));
  EXPECT_TRUE(std::isfinite(found[2].position.y));
}

}  // namespace
