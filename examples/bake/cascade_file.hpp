/// The EXR files of one cascade.
#pragma once

#include <common/gpu_device.hpp>
#include <filesystem>
#include <pelagic/waves.hpp>

namespace bake {

/// Maps of one cascade at one moment: displacement, slope, gradient, jacobian and foam. Needs MapPrecision::single.
void writeCascade(const common::GpuDevice& gpu, const pelagic::WaveMaps& maps, std::uint32_t cascade,
                  const std::filesystem::path& path);
/// Expected E|h(k)|^2 [m^2] of every mode, in FFT order.
void writeVariance(const pelagic::Waves& waves, std::uint32_t cascade, const std::filesystem::path& path);

}  // namespace bake
