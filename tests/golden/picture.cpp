#include "picture.hpp"

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <stdexcept>

namespace golden {

Picture encode(std::uint32_t width, std::uint32_t height, const std::vector<float>& rgba, double exposure) {
  Picture picture{width, height, {}};
  picture.rgb.reserve(std::size_t{width} * height * 3);
  for (std::size_t i = 0; i < rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    const double x = static_cast<double>(rgba[i]) * std::exp2(exposure);
    if (!(x >= 0) || !std::isfinite(x)) throw std::runtime_error("radiance is " + std::to_string(x));
    picture.rgb.push_back(static_cast<std::uint8_t>(std::lround(255 * std::sqrt(x / (1 + x)))));
  }
  return picture;
}

Picture readPng(const std::filesystem::path& path) {
  const auto file = OIIO::ImageInput::open(path.string());
  if (!file) throw std::runtime_error("cannot read " + path.string());
  const OIIO::ImageSpec& spec = file->spec();
  Picture picture{static_cast<std::uint32_t>(spec.width), static_cast<std::uint32_t>(spec.height), {}};
  picture.rgb.resize(std::size_t{picture.width} * picture.height * 3);
  if (spec.nchannels != 3 || !file->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, picture.rgb.data())) {
    throw std::runtime_error(path.string() + " is not an RGB picture");
  }
  return picture;
}

void writePng(const std::filesystem::path& path, const Picture& picture) {
  std::filesystem::create_directories(path.parent_path());
  const auto file = OIIO::ImageOutput::create(path.string());
  OIIO::ImageSpec spec(static_cast<int>(picture.width), static_cast<int>(picture.height), 3, OIIO::TypeDesc::UINT8);
  spec["png:compressionLevel"] = 9;
  if (!file || !file->open(path.string(), spec) || !file->write_image(OIIO::TypeDesc::UINT8, picture.rgb.data()) ||
      !file->close()) {
    throw std::runtime_error("cannot write " + path.string());
  }
}

}  // namespace golden
