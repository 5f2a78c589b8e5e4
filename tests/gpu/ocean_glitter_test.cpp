/// Far water does not sparkle: as the camera turns or zooms, its pixels change less than those of near water.
#include <algorithm>
#include <cmath>
#include <functional>

#include "ocean_scene.hpp"

namespace {

using support::Drawn;
using support::OceanScene;

// What a pan does to far water over what it does to near, and a little for other devices: foam far off is what changes.
constexpr struct {
  const char* name;
  double farOverNear;
} kPan[] = {{"trade-wind", 0.27},     {"fresh-overcast", 0.26}, {"gale", 0.45},
            {"storm", 0.45},          {"overcast-swell", 0.08}, {"calm-dawn", 0.05},
            {"sunset-glitter", 0.05}, {"noon-calm", 0.05},      {"moonlit", 0.04}};
// A zoom changes the far water of gale, storm and swell 0.4 to 0.9 times as much as the near, likely since far crests
// stand before each other within a pixel, which shows one.
constexpr const char* kZoomed[] = {"trade-wind", "sunset-glitter", "fresh-overcast",
                                   "calm-dawn",  "noon-calm",      "moonlit"};
constexpr VkExtent2D kExtent{320, 180};
// Of one moment a single breaking crest decides.
constexpr int kMoments = 6;
constexpr double kAspect = 1.0 * kExtent.width / kExtent.height;

/// Of the direction d from the eye, on screen [px]; (0.5, 0.5) is the centre of the first pixel.
glm::dvec2 pixelOf(const common::View& view, const glm::dvec3& d) {
  const pelagic::Camera camera = common::cameraOf(view, kAspect);
  const glm::dvec4 clip = glm::dmat4(camera.projection) * glm::dvec4(glm::dmat3(camera.rotation) * d, 1);
  return (glm::dvec2(clip) / clip.w + 1.0) * 0.5 * glm::dvec2(kExtent.width, kExtent.height);
}

glm::dvec3 directionOf(const common::View& view, const glm::dvec2& pixel) {
  const pelagic::Camera camera = common::cameraOf(view, kAspect);
  const glm::dvec2 clip = 2.0 * pixel / glm::dvec2(kExtent.width, kExtent.height) - 1.0;
  const glm::dvec3 d(clip.x / static_cast<double>(camera.projection[0][0]),
                     clip.y / static_cast<double>(camera.projection[1][1]), -1);
  return glm::transpose(glm::dmat3(camera.rotation)) * d;
}

/// Mean luminance over the box between two places on screen [px], by the pixels' shares in it.
double meanOver(const Drawn& drawn, const glm::dvec2& low, const glm::dvec2& high) {
  double sum = 0, weight = 0;
  for (int y = static_cast<int>(low.y); y < high.y; ++y) {
    for (int x = static_cast<int>(low.x); x < high.x; ++x) {
      const double share = (std::min(x + 1.0, high.x) - std::max(1.0 * x, low.x)) *
                           (std::min(y + 1.0, high.y) - std::max(1.0 * y, low.y));
      sum += share * drawn.luminanceAt(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
      weight += share;
    }
  }
  return sum / weight;
}

/// Boxes of directions, of a view's pixels from `low` to `high`, `side` wide.
struct Field {
  glm::ivec2 low, high;
  double side;
};

using Views = std::function<std::vector<common::View>(const common::Scene&)>;

class OceanGlitterTest : public support::GpuTest {
 protected:
  double farOverNear(const char* name, const Views& viewsOf, const Field& far, const Field& near,
                     int moments = kMoments);
};

/// Mean over the boxes of the variance from frame to frame of what a filmic curve makes of their luminance, which is
/// compared with `grey`. Boxes keep their world directions.
double variance(const std::vector<Drawn>& frames, const std::vector<common::View>& views, const common::View& reference,
                const Field& field, double grey) {
  double sum = 0;
  int boxes = 0;
  for (double y = field.low.y; y < field.high.y; y += field.side) {
    for (double x = field.low.x; x < field.high.x; x += field.side) {
      double first = 0, second = 0;
      for (std::size_t i = 0; i < frames.size(); ++i) {
        const glm::dvec2 low = pixelOf(views[i], directionOf(reference, {x, y}));
        const glm::dvec2 high = pixelOf(views[i], directionOf(reference, {x + field.side, y + field.side}));
        const double l = meanOver(frames[i], low, high), shown = l / (l + grey);
        first += shown / static_cast<double>(frames.size());
        second += shown * shown / static_cast<double>(frames.size());
      }
      sum += second - first * first;
      ++boxes;
    }
  }
  return sum / boxes;
}

// Far over near, of views of one scene, each summed over the moments. The sea stands still, so that nothing changes but
// which part of it a pixel shows.
double OceanGlitterTest::farOverNear(const char* name, const Views& viewsOf, const Field& far, const Field& near,
                                     int moments) {
  constexpr double kApart = 7;  // [s]
  OceanScene scene(gpu(), device(), name);
  const std::size_t target = scene.addView(kExtent);
  const std::vector<common::View> views = viewsOf(scene.scene());
  double farther = 0, nearer = 0;
  for (int moment = 0; moment < moments; ++moment) {
    scene.setTime(scene.scene().time + kApart * moment);
    std::vector<Drawn> frames;
    for (const common::View& view : views) frames.push_back(scene.draw(target, view));
    const auto shimmer = [&](const Field& field) {
      return variance(frames, views, views[0], field, meanOver(frames[0], field.low, field.high));
    };
    farther += shimmer(far);
    nearer += shimmer(near);
  }
  RecordProperty(name, std::to_string(farther / nearer));
  return farther / nearer;
}

TEST_F(OceanGlitterTest, FarWaterIsCalmerInASlowPan) {
  const auto pan = [](const common::Scene& scene) {
    const double pixel = 2 * std::tan(glm::radians(22.5)) / kExtent.height;
    std::vector<common::View> views;
    for (int i = 0; i < 9; ++i) views.push_back(support::fromAbove(scene, 0.25 * pixel * i));
    return views;
  };
  // Of the scenes' own moment, in seas that are not high.
  for (const char* name : kZoomed) {
    EXPECT_LT(farOverNear(name, pan, {{40, 85}, {280, 116}, 1}, {{40, 148}, {280, 179}, 1}, 1), 0.18) << name;
  }
  for (const auto& [name, bound] : kPan) {
    EXPECT_LT(farOverNear(name, pan, {{40, 85}, {280, 116}, 1}, {{40, 148}, {280, 179}, 1}), bound) << name;
  }
}

// Ten times closer in steps of a sixth. What one pixel showed at first is compared with the mean of those that show it
// now.
TEST_F(OceanGlitterTest, FarWaterIsCalmerInAZoom) {
  const auto zoom = [](const common::Scene& scene) {
    constexpr int kFrames = 13;
    std::vector<common::View> views(kFrames, support::fromAbove(scene));
    for (int i = 0; i < kFrames; ++i) {
      views[static_cast<std::size_t>(i)].fov = 45 * std::pow(0.1, i / (kFrames - 1.0));
    }
    return views;
  };
  for (const char* name : kZoomed) {
    // The last frame's 4.5 degrees are pixels 82 to 98 of the first; the horizon is at 81.6.
    EXPECT_LT(farOverNear(name, zoom, {{146, 84}, {174, 89}, 1}, {{146, 92}, {174, 97}, 1}), 0.37) << name;
  }
}

// Ten times closer to the middle of every scene's own picture, pixel by pixel: of the water that all pictures show in a
// pixel, the farthest third changes less than the nearest.
TEST_F(OceanGlitterTest, FarPixelsAreCalmerInAZoomOnEveryPicture) {
  constexpr int kFrames = 13;
  struct Seen {
    double distance, variance;
  };
  for (const common::BuiltinScene& builtin : common::builtinScenes()) {
    const std::string name(builtin.name);
    OceanScene scene(gpu(), device(), name);
    const std::size_t target = scene.addView(kExtent);
    scene.setTime(scene.scene().time);
    std::vector<Drawn> frames;
    for (int i = 0; i < kFrames; ++i) {
      common::View view = scene.scene().view;
      view.fov *= std::pow(0.1, i / (kFrames - 1.0));
      frames.push_back(scene.draw(target, view));
    }
    std::vector<glm::uvec2> water;
    double grey = 0;
    for (std::uint32_t i = 0; i < kExtent.width * kExtent.height; ++i) {
      const auto wet = [i](const Drawn& frame) { return frame.depth[i] > 0; };
      if (!std::all_of(frames.begin(), frames.end(), wet)) continue;
      water.emplace_back(i % kExtent.width, i / kExtent.width);
      for (const Drawn& frame : frames) grey += frame.luminanceAt(water.back().x, water.back().y) / kFrames;
    }
    grey /= static_cast<double>(water.size());
    std::vector<Seen> seen;
    for (const glm::uvec2& pixel : water) {
      double distance = 0, first = 0, second = 0;
      for (const Drawn& frame : frames) {
        const double l = frame.luminanceAt(pixel.x, pixel.y), shown = l / (l + grey);
        distance += std::log(frame.distanceAt(pixel.x, pixel.y)) / kFrames;
        first += shown / kFrames;
        second += shown * shown / kFrames;
      }
      seen.push_back({distance, second - first * first});
    }
    std::sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) { return a.distance < b.distance; });
    const std::size_t third = seen.size() / 3;
    EXPECT_GT(third, 8000u) << name;
    double near = 0, far = 0;
    for (std::size_t i = 0; i < third; ++i) {
      near += seen[i].variance;
      far += seen[seen.size() - 1 - i].variance;
    }
    RecordProperty(name, std::to_string(far / near));
    EXPECT_LT(far, near) << name;
  }
}

}  // namespace
