#include "environment_file.hpp"

#include <fmt/format.h>

#include "field.hpp"
#include "image_file.hpp"

namespace common {

void readEnvironment(const std::string& where, const std::string& path, pelagic::SkyEnvironment& environment) {
  pelagic::SkyEnvironment read;
  if (path != "none") {
    const FloatImage image = readImage(where, path, path);
    if (image.channels < 3) refuse(where, path, fmt::format("an image of R, G and B, not {} channels", image.channels));
    read.width = image.width;
    read.height = image.height;
    const std::size_t pixels = std::size_t{image.width} * image.height;
    read.radiance.resize(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
      read.radiance[i] = {image.values[i], image.values[pixels + i], image.values[2 * pixels + i]};
    }
    if (const auto valid = pelagic::validate(read); !valid) refuse(where, path, "a sky: " + valid.error().message);
  }
  environment.width = read.width;
  environment.height = read.height;
  environment.radiance = std::move(read.radiance);
}

}  // namespace common
