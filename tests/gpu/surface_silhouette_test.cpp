#include "surface_fixture.hpp"

namespace {

using namespace surface_scene;

/// Twice the pixels and edges twice as long show the mesh of a picture of 1280 x 360 by the half pixel.
constexpr double kZoom = 2;
constexpr VkExtent2D kPicture{2560, 720};
constexpr double kFov = 32.2 * kDegree;  // 91 degrees across
constexpr double kNear = 60;             // [m]

class SilhouetteTest : public SurfaceTest {
 protected:
  /// The row where near water meets the sky, of every column where it does [px of the smaller picture].
  std::vector<std::optional<double>> outline(const pelagic::Camera& camera) {
    const Water water = draw(camera);
    std::vector<std::optional<double>> rows(kPicture.width);
    for (std::uint32_t x = 0; x < kPicture.width; ++x) {
      std::uint32_t y = 0;
      while (y < kPicture.height && !water.covered(x, y)) ++y;
      if (y == 0 || y == kPicture.height) continue;
      const std::size_t i = 2 * water.index(x, y);
      const glm::dvec2 ground(water.position[i], water.position[i + 1]);
      if (glm::length(ground) < kNear) rows[x] = y / kZoom;
    }
    return rows;
  }
  /// Looks level from 0.3 to 2 m over the water.
  void expectSmoothOutlines(double windSpeed) {
    pelagic::SeaState sea;
    sea.windSpeed = windSpeed;
    makeWaves(sea);
    setTime(100);
    std::vector<pelagic::Camera> cameras;
    std::mt19937 random(9);
    for (int n = 0; n < 6; ++n) {
      glm::dvec3 eye(between(random, -1e4, 1e4), 0, between(random, -1e4, 1e4));
      eye.y = 0.3 * std::pow(7.0, between(random, 0, 1)) + query_->heightAt({eye.x, eye.z});
      cameras.push_back(surface_scene::camera(eye, between(random, -3, 3), 0, 0, {kFov}, kPicture));
    }
    makeView(kPicture, static_cast<float>(2 * kZoom));
    std::vector<std::vector<std::optional<double>>> finest;
    for (const pelagic::Camera& camera : cameras) finest.push_back(outline(camera));
    makeView(kPicture, static_cast<float>(pelagic::SurfaceInfo().targetEdge * kZoom));
    double columns = 0, sum = 0, squares = 0;
    for (std::size_t n = 0; n < cameras.size(); ++n) {
      const auto rows = outline(cameras[n]);
      for (std::uint32_t x = 0; x < kPicture.width; ++x) {
        if (!rows[x] || !finest[n][x]) continue;
        const double lower = *rows[x] - *finest[n][x];
        ++columns;
        sum += lower;
        squares += lower * lower;
      }
    }
    ASSERT_GT(columns, 6000);
    const double mean = sum / columns;
    RecordProperty("mean", std::to_string(mean));
    RecordProperty("rms", std::to_string(std::sqrt(squares / columns - mean * mean)));
    // Crests end a little lower, since their shortest waves are below the spacing of the mesh.
    EXPECT_LT(std::abs(mean), 0.9);
    // About that, facets are off by half a pixel. Two outlines by the half pixel are 0.2 off by rounding alone.
    EXPECT_LT(std::sqrt(squares / columns - mean * mean), 0.65);
  }
};

/// Outlines of near waves against the sky are those of the finest mesh.
TEST_F(SilhouetteTest, OfNearWavesIsSmooth) { expectSmoothOutlines(12); }

TEST_F(SilhouetteTest, OfNearWavesInAGaleIsSmooth) { expectSmoothOutlines(20); }

}  // namespace
