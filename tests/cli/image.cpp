#include "image.hpp"

#include <OpenImageIO/imageio.h>

#include <stdexcept>

namespace cli {

Image readImage(const std::filesystem::path& path) {
  const auto file = OIIO::ImageInput::open(path.string());
  if (!file) throw std::runtime_error("cannot read " + path.string() + ": " + OIIO::geterror());
  const OIIO::ImageSpec& spec = file->spec();
  Image image;
  image.width = spec.width;
  image.height = spec.height;
  image.channels = spec.channelnames;
  const std::size_t count = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
  const auto channels = static_cast<std::size_t>(spec.nchannels);
  std::vector<float> pixels(count * channels);
  if (!file->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data())) {
    throw std::runtime_error("cannot read the pixels of " + path.string() + ": " + file->geterror());
  }
  for (std::size_t c = 0; c < channels; ++c) {
    const std::string& name = image.channels[c];
    image.types[name] = spec.channelformat(static_cast<int>(c)).c_str();
    std::vector<double>& values = image.values[name];
    values.resize(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<double>(pixels[i * channels + c]);
  }
  return image;
}

}  // namespace cli
