/// Pictures that are compared: 8 bits per channel, undithered.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace golden {

/// Each channel of the radiance x (times 2^exposure) is stored as round(255 sqrt(x/(1+x))): all of it in range, finely
/// stepped where it is dark, and with a curve that can be undone.
struct Picture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> rgb;  ///< Rows from the top.
};

/// `rgba`: linear radiance, 4 floats a pixel. Throws std::runtime_error at a value that is not finite or below zero.
Picture encode(std::uint32_t width, std::uint32_t height, const std::vector<float>& rgba, double exposure);

/// Both throw std::runtime_error when the file cannot be read or written.
Picture readPng(const std::filesystem::path& path);
void writePng(const std::filesystem::path& path, const Picture& picture);

}  // namespace golden
