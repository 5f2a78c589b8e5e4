#include "cascade_file.hpp"

#include <common/image_file.hpp>

namespace bake {

void writeCascade(const common::GpuDevice& gpu, const pelagic::WaveMaps& maps, std::uint32_t cascade,
                  const std::filesystem::path& path) {
  const auto read = [&](const pelagic::MapView& map) { return common::readFloats(gpu, map, 0, cascade); };
  const std::vector<float> displacement = read(maps.displacement);
  const std::vector<float> gradient = read(maps.gradient);
  const std::vector<float> moments = read(maps.moments);
  const std::vector<float> foam = read(maps.foam);
  const std::size_t texels = std::size_t{maps.layout.size} * maps.layout.size;
  const std::size_t foamComponents = foam.size() / texels;
  std::vector<float> jacobian(texels);
  for (std::size_t i = 0; i < texels; ++i) {
    const float xx = gradient[4 * i + 2];
    const float zz = gradient[4 * i + 3];
    const float xz = moments[4 * i + 3];
    jacobian[i] = (1 + xx) * (1 + zz) - xz * xz;
  }
  using common::floatChannel;
  const common::ExrChannel channels[] = {
      floatChannel("displacement.X", displacement, 4, 0),
      floatChannel("displacement.Y", displacement, 4, 1),
      floatChannel("displacement.Z", displacement, 4, 2),
      floatChannel("slope.X", gradient, 4, 0),
      floatChannel("slope.Z", gradient, 4, 1),
      floatChannel("gradient.XX", gradient, 4, 2),
      floatChannel("gradient.ZZ", gradient, 4, 3),
      floatChannel("gradient.XZ", moments, 4, 3),
      floatChannel("jacobian.V", jacobian, 1, 0),
      floatChannel("foam.V", foam, foamComponents, 0),
  };
  common::writeExr(path, maps.layout.size, maps.layout.size, channels);
}

void writeVariance(const pelagic::Waves& waves, std::uint32_t cascade, const std::filesystem::path& path) {
  const std::vector<double> variance = waves.modeVariance(cascade);
  const std::vector<float> values(variance.begin(), variance.end());
  const std::uint32_t size = waves.maps().layout.size;
  const common::ExrChannel channels[] = {common::floatChannel("variance.V", values, 1, 0)};
  common::writeExr(path, size, size, channels);
}

}  // namespace bake
