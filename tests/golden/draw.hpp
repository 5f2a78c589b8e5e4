/// Draws scenes through the public interface.
#pragma once

#include <common/gpu_device.hpp>
#include <common/scene.hpp>

#include "picture.hpp"

namespace golden {

inline constexpr vk::Extent2D kExtent{480, 270};

common::Scene builtin(std::string_view name);
/// The scene at its own time and exposure. `handles`: of `gpu`, its functions perhaps replaced.
/// Throws std::runtime_error when Pelagic reports an error.
Picture draw(const common::GpuDevice& gpu, const pelagic::DeviceInfo& handles, const common::Scene& scene);
/// Where the golden picture of a scene lies in the source tree.
std::filesystem::path imageOf(std::string_view scene);

}  // namespace golden
