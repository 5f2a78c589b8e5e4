#include "waves_support.hpp"

#include <fftw3.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace support {
namespace {

using Complex = std::complex<double>;

/// Sum over k of spectrum e^{+i k x}; the imaginary part vanishes for the spectrum of a real field.
std::vector<double> inverse(const std::vector<Complex>& spectrum, int size) {
  std::vector<Complex> field = spectrum;
  auto* data = reinterpret_cast<fftw_complex*>(field.data());
  fftw_plan plan = fftw_plan_dft_2d(size, size, data, data, FFTW_BACKWARD, FFTW_ESTIMATE);
  fftw_execute(plan);
  fftw_destroy_plan(plan);
  std::vector<double> real;
  real.reserve(field.size());
  for (const Complex& value : field) real.push_back(value.real());
  return real;
}

double phase(std::uint32_t cycles, double time, double loopPeriod) {
  const long double turns =
      static_cast<long double>(cycles) * static_cast<long double>(time) / static_cast<long double>(loopPeriod);
  return static_cast<double>(2 * std::numbers::pi_v<long double> * (turns - std::floor(turns)));
}

}  // namespace

std::vector<pelagic::SeaState> fiveSeas() {
  std::vector<pelagic::SeaState> seas(5);
  seas[0].windSpeed = 3;
  seas[1].windSpeed = 8;
  seas[1].windDirection = 2;
  seas[2].windSpeed = 17;
  seas[2].spectrum = pelagic::Spectrum::elfouhaily;
  seas[3].windSpeed = 25;
  seas[3].fetch = 400e3;
  seas[3].swell.push_back({4, 16, 1, 30});
  seas[4].windSpeed = 6;
  seas[4].depth = 8;
  seas[4].spectrum = pelagic::Spectrum::tma;
  seas[4].swell.push_back({1, 11, 2, 50});
  return seas;
}

pelagic::WavesInfo wavesInfo(std::uint32_t size, std::uint32_t count, double windSpeed) {
  pelagic::WavesInfo info;
  info.sea.windSpeed = windSpeed;
  info.sea.windDirection = 0.5;
  info.sea.asymmetry = 1;
  info.layout = pelagic::waveLayout(info.sea, count, size).value();
  info.precision = pelagic::MapPrecision::single;
  return info;
}

Fields referenceFields(const pelagic::WavesInfo& info, std::uint32_t cascade, double time) {
  const auto modes = pelagic::makeModes(info.sea, info.layout, cascade, info.loopPeriod);
  const int size = static_cast<int>(info.layout.size);
  const double dk = 2 * std::numbers::pi / info.layout.cascades[cascade].length;
  std::array<std::vector<Complex>, kFields> spectra;
  for (auto& spectrum : spectra) spectrum.resize(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const auto index = static_cast<std::size_t>(row * size + column);
      const double kx = dk * (column < size / 2 ? column : column - size);
      const double kz = dk * (row < size / 2 ? row : row - size);
      const glm::dvec4 a(modes.amplitude[index]);
      const double angle = phase(modes.constants[index].cycles, time, info.loopPeriod);
      const Complex h = Complex(a.x, a.y) * std::polar(1.0, -angle) + Complex(a.z, a.w) * std::polar(1.0, angle);
      const Complex i(0, 1);
      const glm::dvec2 chop(modes.constants[index].chop);
      const Complex moved = i * Complex(chop.x, chop.y) * h;
      const Complex dx = kx * moved;
      const Complex dz = kz * moved;
      const Complex values[kFields] = {h, dx, dz, i * kx * h, i * kz * h, i * kx * dx, i * kz * dz, i * kx * dz};
      for (std::size_t f = 0; f < kFields; ++f) spectra[f][index] = values[f];
    }
  }
  Fields fields;
  for (std::size_t f = 0; f < kFields; ++f) fields[f] = inverse(spectra[f], size);
  return fields;
}

double relativeError(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0;
  double norm = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference += (a[i] - b[i]) * (a[i] - b[i]);
    norm += b[i] * b[i];
  }
  return std::sqrt(difference / norm);
}

double meanOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double varianceOf(const std::vector<double>& values) {
  const double mean = meanOf(values);
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum / static_cast<double>(values.size());
}

pelagic::Waves WavesTest::create(const pelagic::WavesInfo& info) {
  auto waves = pelagic::Waves::create(device(), info);
  if (!waves) throw std::runtime_error(waves.error().message);
  return std::move(*waves);
}

void WavesTest::record(pelagic::Waves& waves, double time) {
  gpu().run([&](vk::CommandBuffer commands) { waves.record(commands, time); });
}

Fields WavesTest::read(const pelagic::WaveMaps& maps, std::uint32_t cascade) {
  const auto displacement = common::readFloats(gpu(), maps.displacement, 0, cascade);
  const auto gradient = common::readFloats(gpu(), maps.gradient, 0, cascade);
  const auto moments = common::readFloats(gpu(), maps.moments, 0, cascade);
  Fields fields;
  for (std::size_t i = 0; i < displacement.size(); i += 4) {
    const float values[kFields] = {displacement[i + 1], displacement[i], displacement[i + 2], gradient[i],
                                   gradient[i + 1],     gradient[i + 2], gradient[i + 3],     moments[i + 3]};
    for (std::size_t f = 0; f < kFields; ++f) fields[f].push_back(static_cast<double>(values[f]));
  }
  return fields;
}

}  // namespace support
