/// The sheet on seas of the wave stage, from everywhere.
#include "surface_fixture.hpp"
#include "water_defects.hpp"

namespace {

using namespace surface_scene;

constexpr VkExtent2D kPicture{192, 108};

class SurfaceSeaTest : public SurfaceTest {
 protected:
  void drawFrom200Cameras(double windSpeed) {
    pelagic::SeaState sea;
    sea.windSpeed = windSpeed;
    makeWaves(sea);
    setTime(100);
    makeView(kPicture, 12);
    const Layer layer = layerOf(gpu(), maps_);
    std::mt19937 random(5);
    double judgedWater = 0, judgedAir = 0;
    int among = 0;
    for (int n = 0; n < 200; ++n) {
      pelagic::Camera camera = randomCamera(random, 0.3, 20e3, kPicture);
      camera.position.y += query_->heightAt({camera.position.x, camera.position.z});
      const Defects defects = defectsOf(draw(camera), camera, layer, false);
      EXPECT_EQ(defects.holes, 0) << "camera " << n << " at " << camera.position.y << " m";
      EXPECT_EQ(defects.above, 0) << "camera " << n << " at " << camera.position.y << " m";
      EXPECT_EQ(defects.cracks, 0) << "camera " << n << " at " << camera.position.y << " m";
      judgedWater += defects.judgedWater;
      judgedAir += defects.judgedAir;
      among += camera.position.y < layer.top;
    }
    // Most cameras look at the sea, the others at the sky; some stand among the crests.
    const double pixels = 200.0 * kPicture.width * kPicture.height;
    EXPECT_GT(judgedWater, 0.8 * pixels);
    EXPECT_GT(judgedAir, 0.1 * pixels);
    EXPECT_GE(among, 25);
  }
};

TEST_F(SurfaceSeaTest, NoHoleNoCrackNoWaterInTheAirFrom200Cameras) { drawFrom200Cameras(12); }

TEST_F(SurfaceSeaTest, NoHoleNoCrackNoWaterInTheAirFrom200CamerasInAGale) { drawFrom200Cameras(20); }

/// Crests wash over an eye that stays where it is.
TEST_F(SurfaceSeaTest, CrestsPassOverTheEye) {
  pelagic::SeaState sea;
  sea.windSpeed = 12;
  makeWaves(sea, 3, 64);
  makeView(kPicture, 12);
  int above = 0, below = 0, passages = 0;
  bool wasBelow = false;
  for (int n = 0; n < 120; ++n) {
    setTime(0.3 * n);
    Lens lens{60 * kDegree};
    lens.reversed = n % 3 != 0;
    if (!lens.reversed) lens.far = 1e4;
    // Four heights, 9 s each.
    const glm::dvec3 eye(1e7, 0.5 * (n / 30 - 1.5) * maps_.elevationDeviation, -3e6);
    const double gap = eye.y - query_->heightAt({eye.x, eye.z});
    const pelagic::Camera camera =
        surface_scene::camera(eye, 0.8 * (n / 30), 0.2 * (n % 5 - 2), 0.3 * (n % 7 - 3), lens, kPicture);
    const Water water = draw(camera);
    const Layer layer{-6 * maps_.elevationDeviation, 6 * maps_.elevationDeviation};
    // Within the bulge of a cell either side may be the drawn one.
    const bool either = std::abs(gap) < 0.03;
    const bool isBelow = gap < 0;
    int holes = defectsOf(water, camera, layer, isBelow).holes;
    if (either) holes = std::min(holes, defectsOf(water, camera, layer, !isBelow).holes);
    EXPECT_EQ(holes, 0) << "frame " << n << ", the eye " << gap << " m over the water";
    passages += n > 0 && isBelow != wasBelow;
    wasBelow = isBelow;
    if (!either) ++(isBelow ? below : above);
  }
  EXPECT_GE(above, 40);
  EXPECT_GE(below, 40);
  EXPECT_GE(passages, 6);
}

TEST_F(SurfaceSeaTest, WaterIsWhereTheQueryFindsItFarFromTheOrigin) {
  pelagic::SeaState sea;
  sea.windSpeed = 12;
  makeWaves(sea);
  setTime(100);
  const VkExtent2D extent{480, 270};
  makeView(extent, 4);
  std::mt19937 random(8);
  for (const double away : {0.0, 1e7}) {
    double sum = 0;
    int pixels = 0;
    for (int n = 0; n < 4; ++n) {
      glm::dvec3 eye(away + between(random, -100, 100), 0, between(random, -100, 100) - away);
      eye.y = 3 + query_->heightAt({eye.x, eye.z});
      const pelagic::Camera camera = surface_scene::camera(eye, n, -0.8, 0.2 * n, {50 * kDegree}, extent);
      const Water water = draw(camera);
      for (std::uint32_t i = 0; i < extent.width * extent.height; i += 37) {
        const auto hit = query_->intersect(eye, ray(camera, water.uv(i % extent.width, i / extent.width)), 100);
        ASSERT_TRUE(hit && water.body[i] != 0) << "pixel " << i;
        const glm::dvec2 ground(water.position[2 * i], water.position[2 * i + 1]);
        const double miss = glm::length(glm::dvec2(eye.x, eye.z) + ground - hit->undisplaced);
        sum += miss * miss;
        ++pixels;
      }
    }
    // A pixel is 1 to 3 cm wide there.
    EXPECT_LT(std::sqrt(sum / pixels), 0.015) << away << " m from the origin";
  }
}

}  // namespace
