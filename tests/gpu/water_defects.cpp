#include "water_defects.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace surface_scene {
namespace {

constexpr std::array<glm::dvec2, 5> kAround{{{0, 0}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

bool mayShowWater(const pelagic::Camera& camera, const glm::dvec2& uv, VkExtent2D extent, double top) {
  return std::any_of(kAround.begin(), kAround.end(), [&](const glm::dvec2& offset) {
    return hitSphere(camera, ray(camera, uv + offset / glm::dvec2(extent.width, extent.height)), top) >= 0;
  });
}

/// Calls `visit` with the index of each of the up to eight pixels around one; returns whether there are eight.
template <class Visit>
bool forAround(const Water& water, std::size_t index, const Visit& visit) {
  const auto x = static_cast<std::int64_t>(index % water.extent.width);
  const auto y = static_cast<std::int64_t>(index / water.extent.width);
  bool all = true;
  for (std::int64_t j = y - 1; j <= y + 1; ++j) {
    for (std::int64_t i = x - 1; i <= x + 1; ++i) {
      if (i == x && j == y) continue;
      if (i < 0 || j < 0 || i >= water.extent.width || j >= water.extent.height) {
        all = false;
      } else {
        visit(static_cast<std::size_t>(j * water.extent.width + i));
      }
    }
  }
  return all;
}

/// Pixels of connected patches, with or without water, that do not reach the picture's border.
int enclosed(const Water& water) {
  std::vector<bool> seen(water.body.size());
  std::vector<std::size_t> patch;
  int pixels = 0;
  for (std::size_t first = 0; first < seen.size(); ++first) {
    if (seen[first]) continue;
    seen[first] = true;
    patch = {first};
    bool open = false;
    for (std::size_t next = 0; next < patch.size(); ++next) {
      const bool inside = forAround(water, patch[next], [&](std::size_t i) {
        if (seen[i] || water.body[i] != water.body[first]) return;
        seen[i] = true;
        patch.push_back(i);
      });
      open = open || !inside;
    }
    if (!open) pixels += static_cast<int>(patch.size());
  }
  return pixels;
}

int seenThrough(const Water& water, double height) {
  const auto distance = [&](std::size_t i) {
    return std::hypot(static_cast<double>(water.position[2 * i]), static_cast<double>(water.position[2 * i + 1]),
                      height);
  };
  int pixels = 0;
  for (std::size_t i = 0; i < water.body.size(); ++i) {
    double farthest = 0;
    const bool all = forAround(
        water, i, [&](std::size_t j) { farthest = std::max(farthest, water.body[j] == 0 ? HUGE_VAL : distance(j)); });
    pixels += all && water.body[i] != 0 && distance(i) > 1.2 * farthest;
  }
  return pixels;
}

}  // namespace

Layer layerOf(const common::GpuDevice& gpu, const pelagic::WaveMaps& maps) {
  Layer layer;
  for (std::uint32_t c = 0; c < maps.layout.count; ++c) {
    const std::vector<float> texels = common::readFloats(gpu, maps.displacement, 0, c);
    float low = 0, high = 0;
    for (std::size_t i = 1; i < texels.size(); i += 4) {
      low = std::min(low, texels[i]);
      high = std::max(high, texels[i]);
    }
    layer.bottom += static_cast<double>(low);
    layer.top += static_cast<double>(high);
  }
  return layer;
}

bool mustShowWater(const pelagic::Camera& camera, const glm::dvec2& uv, VkExtent2D extent, double level) {
  return std::all_of(kAround.begin(), kAround.end(), [&](const glm::dvec2& offset) {
    const glm::dvec3 direction = ray(camera, uv + offset / glm::dvec2(extent.width, extent.height));
    // From below the sphere closes beyond every horizon.
    if (level > camera.position.y && direction.y < 0.02 * glm::length(direction)) return false;
    return hitSphere(camera, direction, level) >= 0;
  });
}

Defects defectsOf(const Water& water, const pelagic::Camera& camera, const Layer& layer, bool below) {
  Defects defects;
  for (std::uint32_t y = 0; y < water.extent.height; ++y) {
    for (std::uint32_t x = 0; x < water.extent.width; ++x) {
      const glm::dvec2 uv = water.uv(x, y);
      const bool must = mustShowWater(camera, uv, water.extent, below ? layer.top : layer.bottom);
      defects.judgedWater += must;
      defects.holes += must && !water.covered(x, y);
      if (camera.position.y <= layer.top) continue;
      const bool air = !mayShowWater(camera, uv, water.extent, layer.top);
      defects.judgedAir += air;
      defects.above += air && water.covered(x, y);
    }
  }
  defects.cracks = enclosed(water) + seenThrough(water, camera.position.y);
  return defects;
}

}  // namespace surface_scene
