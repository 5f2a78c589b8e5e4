/// What Surface and its views share.
#pragma once

#include <gpu/compute_pass.hpp>
#include <optional>
#include <pelagic/surface.hpp>

namespace pelagic {

struct Surface::Impl {
  gpu::Context* context = nullptr;
  SurfaceInfo info;
  gpu::Unique<vk::Sampler> sampler;
  gpu::Unique<vk::Sampler> nearest;
  /// Without and with a map of gains, compiled when the first view needs it.
  std::array<std::optional<gpu::ComputePass>, 2> tessellate;
  gpu::ComputePass select;
  gpu::DescriptorLayout drawDescriptors;
  gpu::Unique<vk::PipelineLayout> drawLayout;
  /// Indexed by Camera::reversedDepth.
  std::array<gpu::Unique<vk::Pipeline>, 2> draw;
  /// The triangles of one block; the same for all.
  gpu::Buffer indices;

  Result<const gpu::ComputePass*> tessellateWith(bool gain);
};

namespace surface {

/// Bindings of tessellate.comp, of select_blocks.comp and of the draw.
enum TessellateBinding : std::uint32_t { tFrame, tRows, tDisplacement, tPrevious, tVertices, tFlags, tGain };
enum SelectBinding : std::uint32_t { sFlags, sVisible, sArguments, sFrame };
enum DrawBinding : std::uint32_t { dFrame, dVertices, dVisible };

inline constexpr vk::Format kPositionFormat = vk::Format::eR32G32Sfloat;
inline constexpr vk::Format kMotionFormat = vk::Format::eR16G16Sfloat;
inline constexpr vk::Format kBodyFormat = vk::Format::eR8Uint;
inline constexpr vk::Format kDepthFormat = vk::Format::eD32Sfloat;

}  // namespace surface
}  // namespace pelagic
