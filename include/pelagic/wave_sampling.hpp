/// Fills the block with which shaders find the sea in the wave maps.
#pragma once

#include <pelagic/shader/wave_sampling.h>

#include <pelagic/waves.hpp>

namespace pelagic {

/// `origin`: the world (x,z) to which shader positions are relative [m], usually the camera's; exact to 1e9 m.
shader::WaveSampling waveSampling(const WaveMaps& maps, const glm::dvec2& origin) noexcept;

}  // namespace pelagic
