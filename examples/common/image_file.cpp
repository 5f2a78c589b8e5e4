#include "image_file.hpp"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <cstring>

#include "failure.hpp"
#include "field.hpp"

namespace common {
namespace {

void write(const std::filesystem::path& path, const char* format, const OIIO::ImageSpec& spec, const void* pixels,
           OIIO::stride_t stride) {
  const auto file = OIIO::ImageOutput::create(format);
  // UNKNOWN: the pixels are in the file's own types.
  const OIIO::TypeDesc type = spec.channelformats.empty() ? spec.format : OIIO::TypeDesc::UNKNOWN;
  if (!file || !file->open(path.string(), spec) || !file->write_image(type, pixels, stride) || !file->close()) {
    throw Failure(ExitCode::device,
                  fmt::format("cannot write '{}': {}", path.string(), file ? file->geterror() : OIIO::geterror()));
  }
}

}  // namespace

ExrChannel floatChannel(std::string name, const std::vector<float>& pixels, std::size_t components, std::size_t index) {
  return {std::move(name), false, reinterpret_cast<const std::byte*>(pixels.data() + index),
          components * sizeof(float)};
}

FloatImage readImage(const std::string& where, const std::string& text, const std::string& path) {
  const auto file = OIIO::ImageInput::open(path);
  if (!file) refuse(where, text, "an image in FILE: " + OIIO::geterror());
  const OIIO::ImageSpec& spec = file->spec();
  // Not to run out of memory over a number in a broken header.
  constexpr std::int64_t kMostPixels = 1 << 25;
  if (std::int64_t{spec.width} * spec.height > kMostPixels) {
    refuse(where, text,
           fmt::format("an image in FILE of at most {} pixels, not {} x {}", kMostPixels, spec.width, spec.height));
  }
  FloatImage image;
  image.width = static_cast<std::uint32_t>(spec.width);
  image.height = static_cast<std::uint32_t>(spec.height);
  image.channels = static_cast<std::uint32_t>(spec.nchannels);
  const std::size_t pixels = std::size_t{image.width} * image.height;
  std::vector<float> interleaved(pixels * image.channels);
  if (!file->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, interleaved.data())) {
    refuse(where, text, "an image in FILE: " + file->geterror());
  }
  image.values.resize(interleaved.size());
  for (std::size_t i = 0; i < interleaved.size(); ++i) {
    image.values[i % image.channels * pixels + i / image.channels] = interleaved[i];
  }
  return image;
}

void writeExr(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
              std::span<const ExrChannel> channels) {
  OIIO::ImageSpec spec(static_cast<int>(width), static_cast<int>(height), static_cast<int>(channels.size()),
                       OIIO::TypeDesc::FLOAT);
  spec.channelnames.clear();
  std::size_t pixelBytes = 0;
  for (const ExrChannel& channel : channels) {
    spec.channelnames.push_back(channel.name);
    spec.channelformats.push_back(channel.half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
    pixelBytes += channel.half ? 2 : 4;
  }
  spec.attribute("compression", "zip");
  spec.attribute("oiio:ColorSpace", "Linear");
  spec.attribute("DateTime", "");  // else the moment of writing: the same input gives the same file
  const std::size_t count = std::size_t{width} * height;
  std::vector<std::byte> packed(count * pixelBytes);
  std::size_t offset = 0;
  for (const ExrChannel& channel : channels) {
    const std::size_t bytes = channel.half ? 2 : 4;
    for (std::size_t i = 0; i < count; ++i) {
      std::memcpy(packed.data() + i * pixelBytes + offset, channel.first + i * channel.stride, bytes);
    }
    offset += bytes;
  }
  write(path, "exr", spec, packed.data(), OIIO::AutoStride);
}

void writePng(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
              std::span<const std::byte> rgba) {
  OIIO::ImageSpec spec(static_cast<int>(width), static_cast<int>(height), 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  write(path, "png", spec, rgba.data(), 4);
}

}  // namespace common
