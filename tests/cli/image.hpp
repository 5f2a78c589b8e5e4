/// Image files as tests look at them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace cli {

struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;         ///< In the file's order.
  std::map<std::string, std::string> types;  ///< "half", "float", "uint8" of each channel.
  std::map<std::string, std::vector<double>> values;

  const std::vector<double>& operator[](const std::string& channel) const { return values.at(channel); }
  double at(const std::string& channel, int x, int y) const {
    return values.at(channel)[static_cast<std::size_t>(y * width + x)];
  }
};
/// Throws when the file cannot be read.
Image readImage(const std::filesystem::path& path);

}  // namespace cli
