/// One budget of slope variance from a metre to 50 km: what pixels show of the slopes and what they leave to the BRDF.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <pelagic/ocean.hpp>
#include <pelagic/query.hpp>
#include <random>

#include "support/gpu_test.hpp"

namespace {

using namespace pelagic;

constexpr std::uint32_t kSide = 64;  ///< Of the picture [px].
constexpr float kFocal = 2;          ///< 53 degrees across, 1.6 cm a pixel at 1 m.
constexpr int kSeeds = 6;
constexpr int kTimes = 2;
constexpr double kFarthest = 50000;

/// Looks at `target` [m] from `distance` [m] away, `down` [rad] below the horizontal, toward +x.
Camera lookingAt(const glm::dvec3& target, double distance, double down) {
  const glm::dvec3 forward(std::cos(down), -std::sin(down), 0);
  Camera camera;
  camera.position = target - distance * forward;
  camera.rotation = glm::mat3(glm::lookAt(glm::dvec3(0), forward, glm::dvec3(std::sin(down), std::cos(down), 0)));
  camera.projection = {{kFocal, 0, 0, 0}, {0, -kFocal, 0, 0}, {0, 0, 0, -1}, {0, 0, 0.1f, 0}};
  return camera;
}

glm::dvec2 slopeOf(const glm::dvec3& normal) { return glm::dvec2(normal.x, normal.z) / -normal.y; }

/// Slope variances along x and z [1].
struct Budget {
  glm::dvec2 shown{0};    ///< Mean square of the slopes that pixels show.
  glm::dvec2 left{0};     ///< Mean of the variance within them.
  glm::dvec2 queried{0};  ///< Mean square of the slopes of a SeaQuery at the same places.
};

class OceanVarianceTest : public support::GpuTest {
 protected:
  common::OwnedImage image(vk::Format format) {
    return common::createImage(gpu(), format, {kSide, kSide},
                               vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eTransferSrc, "variance");
  }
  std::vector<float> read(const common::OwnedImage& image) {
    return common::readFloats(gpu(), *image.image, image.format, image.extent, common::kTransferSource);
  }
  void TearDown() override {
    view_.reset();
    ocean_.reset();
    GpuTest::TearDown();
  }
  void create(double choppiness) {
    info_.waves.sea.choppiness = choppiness;
    info_.waves.precision = MapPrecision::single;
    info_.waves.layout = waveLayout(info_.waves.sea).value();
    // Slopes do not depend on the sky. A picture's is the same from every height; air is followed anew from each, in
    // twice the time of all else.
    info_.environment.width = 4;
    info_.environment.height = 2;
    info_.environment.radiance.assign(8, glm::vec3(1));
    output_ = image(vk::Format::eR16G16B16A16Sfloat);
    normal_ = image(vk::Format::eR32G32B32A32Sfloat);
    variance_ = image(vk::Format::eR32G32Sfloat);
    depth_ = image(vk::Format::eR32Sfloat);
    CompositeTargets targets;
    targets.output = output_.host({}, common::kTransferSource);
    targets.normal = normal_.host({}, common::kTransferSource);
    targets.slopeVariance = variance_.host({}, common::kTransferSource);
    targets.mergedDepth = depth_.host({}, common::kTransferSource);
    ocean_.emplace(Ocean::create(device(), info_).value());
    view_.emplace(ocean_->createView(targets).value());
    query_.emplace(SeaQuery::create(info_.waves).value());
  }
  /// Means over one picture.
  Budget look(const Camera& camera) {
    gpu().run([&](vk::CommandBuffer commands) { view_->record(commands, camera); });
    const auto normals = read(normal_), variances = read(variance_), depths = read(depth_);
    const glm::dmat4 toWorld = glm::inverse(glm::dmat4(camera.projection) * glm::dmat4(glm::mat4(camera.rotation)));
    Budget mean;
    constexpr std::uint32_t kStride = 2;
    constexpr double kWeight = 1.0 * kStride * kStride / (kSide * kSide);
    for (std::uint32_t y = 0; y < kSide; y += kStride) {
      for (std::uint32_t x = 0; x < kSide; x += kStride) {
        const std::size_t i = y * kSide + x;
        const glm::dvec2 slope = slopeOf({normals[4 * i], normals[4 * i + 1], normals[4 * i + 2]});
        const glm::dvec4 clip(2 * (x + 0.5) / kSide - 1, 2 * (y + 0.5) / kSide - 1, depths[i], 1);
        const glm::dvec4 p = toWorld * clip;
        const glm::dvec2 place(camera.position.x + p.x / p.w, camera.position.z + p.z / p.w);
        const glm::dvec2 queried = slopeOf(query_->at(place).normal);
        mean.shown += kWeight * slope * slope;
        mean.left += kWeight * glm::dvec2(variances[2 * i], variances[2 * i + 1]);
        mean.queried += kWeight * queried * queried;
      }
    }
    return mean;
  }
  void checkBudget(const std::vector<double>& distances, double tolerance);

  OceanInfo info_;
  common::OwnedImage output_, normal_, variance_, depth_;
  std::optional<Ocean> ocean_;
  std::optional<OceanView> view_;
  std::optional<SeaQuery> query_;
};

/// The mean over many seas. A near picture holds few of the long waves: what they have by chance is taken off by what
/// the queries find at the same places, and their mean over many others added. Pictures are taken from above, where
/// waves hide nothing; pixels that are larger where the sea faces them then weigh slopes by an odd function, which
/// leaves mean squares.
void OceanVarianceTest::checkBudget(const std::vector<double>& distances, double tolerance) {
  constexpr double kOneByOne = 200;  // the farther pictures hold many waves of any length [m]
  constexpr int kPlaces = 10000;
  constexpr double kMean = 1.0 / (kSeeds * kTimes);
  const double downs[] = {1.57, 0.8};
  std::vector<glm::dvec2> sums(2 * distances.size(), glm::dvec2(0));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> where(-5000, 5000);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    info_.waves.sea.seed = seed;
    ASSERT_TRUE(ocean_->setSea(info_.waves.sea));
    ASSERT_TRUE(query_->setSea(info_.waves.sea));
    for (int t = 0; t < kTimes; ++t) {
      const double time = 100 + 1000 * t;
      query_->setTime(time);
      glm::dvec2 queried(0);
      for (int i = 0; i < kPlaces; ++i) {
        const glm::dvec2 slope = slopeOf(query_->at({where(random), where(random)}).normal);
        queried += slope * slope / static_cast<double>(kPlaces);
      }
      gpu().run([&](vk::CommandBuffer commands) { ocean_->record(commands, time); });
      for (std::size_t i = 0; i < sums.size(); ++i) {
        const double distance = distances[i / 2];
        // Least even are those as large as the waves that their pixels begin to miss, and near ones where a long wave
        // makes the ripples steep or calm.
        const int pictures = distance > 200 ? 1 : info_.waves.sea.choppiness > 0 ? 5 : distance > 5 ? 4 : 1;
        for (int picture = 0; picture < pictures; ++picture) {
          const glm::dvec2 place(where(random), where(random));
          const Budget one = look(lookingAt({place.x, query_->heightAt(place), place.y}, distance, downs[i % 2]));
          const glm::dvec2 chance = distance < kOneByOne ? queried - one.queried : glm::dvec2(0);
          sums[i] += kMean / pictures * (one.shown + one.left + chance);
        }
      }
    }
  }
  const SeaReport report = ocean_->waves().report();
  const double upwind = report.grid.upwind + report.unresolved.upwind;
  const double crosswind = report.grid.crosswind + report.unresolved.crosswind;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const std::string place = std::to_string(distances[i / 2]) + " m, " + std::to_string(downs[i % 2]) + " down";
    EXPECT_NEAR((sums[i].x + sums[i].y) / (upwind + crosswind), 1, tolerance) << place;
    EXPECT_NEAR(sums[i].x / upwind, 1, 1.5 * tolerance) << place;
    EXPECT_NEAR(sums[i].y / crosswind, 1, 1.5 * tolerance) << place;
    RecordProperty(place, std::to_string((sums[i].x + sums[i].y) / (upwind + crosswind)));
  }
}

TEST_F(OceanVarianceTest, IsTheSameAtEveryDistance) {
  create(0);
  checkBudget({1, 3, 10, 30, 100, 300, 1000, 3000, 10000, kFarthest}, 0.02);
}

// Displaced slopes go as 1/J, which the steep sides of crests gain more by than they lose in area: 2 % near by.
TEST_F(OceanVarianceTest, HoldsForSharpCrests) {
  create(1);
  checkBudget({1, 30, 300}, 0.04);
}

}  // namespace
