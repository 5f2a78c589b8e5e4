/// Draws a scene and writes its pictures.
#pragma once

#include <common/scene.hpp>
#include <filesystem>

#include "aov.hpp"

namespace render {

enum class Format { png, exr };

struct RendererInfo {
  common::Scene scene;
  VkExtent2D extent{1280, 720};
  Format format = Format::png;
  std::vector<Aov> aovs;  ///< For Format::exr.
};

class Renderer {
 public:
  Renderer(const common::GpuDevice& gpu, pelagic::Device& device, const RendererInfo& info);

  /// Draws the moment `time` [s] and waits for it. Returns the GPU time of every pass.
  std::span<const pelagic::Timings::Pass> draw(double time);
  /// Writes what was drawn last to a path from OutputSet::add.
  void write(const std::filesystem::path& path) const;

  const pelagic::Waves& waves() const { return ocean_.waves(); }
  /// Triangles of the surface as drawn last.
  std::uint32_t triangles() const;

 private:
  void writeLinear(const std::filesystem::path& path) const;

  const common::GpuDevice* gpu_;
  RendererInfo info_;
  pelagic::Camera camera_;
  common::OwnedImage hdr_;
  common::OwnedImage ldr_;  ///< For Format::png.
  AovImages aovImages_;
  pelagic::Ocean ocean_;
  std::optional<pelagic::OceanView> view_;
  std::optional<pelagic::ToneMap> toneMap_;
  pelagic::Timings timings_;
};

}  // namespace render
