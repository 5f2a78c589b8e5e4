/// PNG and OpenEXR files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace common {

/// One channel of an OpenEXR file, picked out of interleaved pixels.
struct ExrChannel {
  std::string name;
  bool half = false;         ///< 16-bit float, else 32-bit.
  const std::byte* first{};  ///< The channel's value of the first pixel, rows from the top.
  std::size_t stride = 0;    ///< Bytes from one pixel to the next.
};
/// Component `index` of interleaved floats.
ExrChannel floatChannel(std::string name, const std::vector<float>& pixels, std::size_t components, std::size_t index);

/// An image's pixels as floats, channel by channel, rows from the top.
struct FloatImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t channels = 0;
  std::vector<float> values;
};
/// Any file that OpenImageIO reads. Throws a Failure that names `where` and `text`, which has named the file.
FloatImage readImage(const std::string& where, const std::string& text, const std::string& path);

/// Both throw a Failure when the file cannot be written. `path` comes from OutputSet::add.
void writeExr(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
              std::span<const ExrChannel> channels);
/// `rgba`: 8-bit sRGB; alpha is dropped.
void writePng(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
              std::span<const std::byte> rgba);

}  // namespace common
