#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <gpu/field.hpp>
#include <limits>
#include <numbers>
#include <sky/host_sky.hpp>
#include <sky/sky_impl.hpp>
#include <sstream>

#include "physics/atmosphere.glsl"

namespace pelagic {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr float kBrightest = 1e9f;
constexpr std::uint32_t kWidest = 4096;
constexpr double kAny = std::numeric_limits<double>::max();
constexpr char kOwner[] = "SkyEnvironment::";

template <class T>
tl::unexpected<Error> rejectField(const std::string& field, const T& value, const std::string& range) {
  std::ostringstream text;
  text << kOwner << field << " is " << value << ", it must " << range;
  return gpu::reject(text.str());
}

std::string textOf(const glm::vec3& c) {
  std::ostringstream text;
  text << '(' << c.r << ", " << c.g << ", " << c.b << ')';
  return text.str();
}

/// Written so that NaN fails.
bool inRange(const glm::vec3& c) {
  return c.r >= 0 && c.g >= 0 && c.b >= 0 && c.r <= kBrightest && c.g <= kBrightest && c.b <= kBrightest;
}

Result<void> validate(const EnvironmentSun& sun) {
  PELAGIC_CHECK(gpu::check(kOwner, {{"sun.elevation", sun.elevation, 0, kPi / 2 + 1e-6, "0 to pi/2"},
                                    {"sun.azimuth", sun.azimuth, -kAny, kAny, "finite"}}));
  if (!inRange(sun.irradiance)) {
    return rejectField("sun.irradiance", textOf(sun.irradiance), "lie in 0 … 1e9 in each channel");
  }
  return {};
}

}  // namespace

Result<void> validate(const SkyEnvironment& environment) {
  const auto& [width, height, radiance, scale, rotation, sun] = environment;
  if (width == 0 && (height > 0 || !radiance.empty())) {
    return rejectField("width", width, "lie in 4 … 4096 where there is a picture");
  }
  PELAGIC_CHECK(
      gpu::check(kOwner, {{"scale", scale, 0, 1e6, "0 to 1e6"}, {"rotation", rotation, -kAny, kAny, "finite"}}));
  if (sun) PELAGIC_CHECK(validate(*sun));
  if (width == 0 && sun) return rejectField("width", width, "lie in 4 … 4096 where a sun is given");
  if (width == 0) return {};
  if (width < 4 || width > kWidest || width % 4 != 0) {
    return rejectField("width", width, "be a multiple of 4 in 4 … 4096, or 0 for no picture");
  }
  if (height != width / 2) return rejectField("height", height, "be half of width, " + std::to_string(width / 2));
  const std::size_t count = std::size_t{width} * height;
  if (radiance.size() != count) {
    return rejectField("radiance.size()", radiance.size(), "be width x height, " + std::to_string(count));
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (inRange(radiance[i])) continue;
    return rejectField("radiance[" + std::to_string(i) + "]", textOf(radiance[i]), "lie in 0 … 1e9 in each channel");
  }
  return {};
}

namespace sky {
namespace {

constexpr double kSunReach = 2.5 * kPi / 180;  ///< From the brightest pixel, within which its light is the sun's [rad].
constexpr double kSunContrast = 4;             ///< Least ratio of the mean luminance there to that of the ring around.
constexpr double kLargestHalf = 6e4;

double luminance(const glm::dvec3& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

/// The sky's half of a picture, in the picture's own frame.
class Hemisphere {
 public:
  explicit Hemisphere(const SkyEnvironment& environment) : environment_(environment) {
    for (std::uint32_t y = 0; y <= rows(); ++y) sines_.push_back(std::cos(kPi / 2 * y / rows()));
    for (std::uint32_t x = 0; x < width(); ++x) {
      const double azimuth = 2 * kPi * (x + 0.5) / width();
      azimuths_.emplace_back(std::cos(azimuth), std::sin(azimuth));
    }
  }

  std::uint32_t width() const { return environment_.width; }
  std::uint32_t rows() const { return environment_.height / 2; }
  glm::dvec3 at(std::uint32_t x, std::uint32_t y) const {
    return environment_.scale * glm::dvec3(environment_.radiance[std::size_t{y} * width() + x]);
  }
  /// Solid angle of a pixel [sr].
  double solidAngle(std::uint32_t y) const { return 2 * kPi / width() * (sines_[y] - sines_[y + 1]); }
  /// Toward the middle of a pixel; y is the exact mean over it of the sine, so that sums are irradiances.
  glm::dvec3 direction(std::uint32_t x, std::uint32_t y) const {
    const double up = 0.5 * (sines_[y] + sines_[y + 1]), side = std::sqrt(1 - up * up);
    return {side * azimuths_[x].x, up, side * azimuths_[x].y};
  }

 private:
  const SkyEnvironment& environment_;
  std::vector<double> sines_;         ///< Of the elevation of each row's upper edge, and of the horizon.
  std::vector<glm::dvec2> azimuths_;  ///< Cosine and sine of each column's.
};

/// Where a sun is, if there is one.
struct SunSpot {
  glm::dvec3 centre{0, 1, 0};
  double cosine = 2;     ///< Of its angular radius; 2: there is none.
  glm::dvec3 ground{0};  ///< Radiance of the sky around it.

  bool holds(const glm::dvec3& direction) const { return glm::dot(direction, centre) >= cosine; }
};

template <class Visit>
void forEachPixel(const Hemisphere& sky, const Visit& visit) {
  for (std::uint32_t y = 0; y < sky.rows(); ++y) {
    for (std::uint32_t x = 0; x < sky.width(); ++x) visit(x, y);
  }
}

SunSpot findSun(const Hemisphere& sky) {
  double most = 0;
  SunSpot spot;
  forEachPixel(sky, [&](std::uint32_t x, std::uint32_t y) {
    const double here = luminance(sky.at(x, y));
    if (here <= most) return;
    most = here;
    spot.centre = glm::normalize(sky.direction(x, y));
  });
  const double pixel = 2 * kPi / sky.width(), reach = std::max(kSunReach, 1.5 * pixel);
  // Thin, so that an aureole that is cut off at its mean shows no edge.
  const double inner = std::cos(reach), outer = std::cos(reach + std::max(0.2 * reach, pixel));
  glm::dvec3 inside(0), around(0);
  double insideAngle = 0, aroundAngle = 0;
  forEachPixel(sky, [&](std::uint32_t x, std::uint32_t y) {
    const double cosine = glm::dot(sky.direction(x, y), spot.centre), angle = sky.solidAngle(y);
    if (cosine < outer) return;
    (cosine >= inner ? inside : around) += angle * sky.at(x, y);
    (cosine >= inner ? insideAngle : aroundAngle) += angle;
  });
  if (most <= 0 || aroundAngle <= 0) return spot;
  spot.ground = around / aroundAngle;
  if (luminance(inside) / insideAngle >= kSunContrast * luminance(spot.ground)) spot.cosine = inner;
  return spot;
}

/// A direction of the picture in the world.
EnvironmentSun sunOf(const glm::dvec3 (&flux)[3], double rotation) {
  const glm::dvec3 all = 0.2126 * flux[0] + 0.7152 * flux[1] + 0.0722 * flux[2];
  if (glm::length(all) <= 0) return {};
  const glm::dvec3 toward = glm::normalize(all);
  EnvironmentSun sun;
  sun.elevation = std::asin(std::clamp(toward.y, 0.0, 1.0));
  sun.azimuth = std::atan2(toward.z, toward.x) + rotation;
  for (int c = 0; c < 3; ++c) sun.irradiance[c] = static_cast<float>(std::max(glm::dot(flux[c], toward), 0.0));
  return sun;
}

}  // namespace

HostSky hostSky(const SkyEnvironment& environment) {
  HostSky result;
  result.width = environment.width;
  if (environment.width == 0) return result;
  const Hemisphere sky(environment);
  result.rows = sky.rows();
  result.rotation = environment.rotation;
  result.texels.reserve(std::size_t{sky.width()} * sky.rows());
  const SunSpot spot = environment.sun ? SunSpot{} : findSun(sky);
  glm::dvec3 irradiance(0), flux[3]{};  // flux: of each channel, the sun's light times its direction
  forEachPixel(sky, [&](std::uint32_t x, std::uint32_t y) {
    const glm::dvec3 light = sky.at(x, y), direction = sky.direction(x, y);
    const glm::dvec3 rest = spot.holds(direction) ? glm::min(light, spot.ground) : light;
    const glm::dvec3 shown = glm::min(rest, kLargestHalf);
    for (int c = 0; c < 3; ++c) flux[c] += sky.solidAngle(y) * (light[c] - rest[c]) * direction;
    irradiance += sky.solidAngle(y) * direction.y * shown;
    result.texels.push_back(glm::packHalf(glm::vec4(shown, 1)));
  });
  result.skyIrradiance = glm::vec3(irradiance);
  result.sun = environment.sun ? *environment.sun : sunOf(flux, environment.rotation);
  return result;
}

shader::SkyLight hostLight(const HostSky& sky, const SkyState& state) noexcept {
  constexpr double kRadius = kSunAngularRadius;
  shader::SkyLight light{};
  light.sunDirection = glm::vec4(toward(sky.sun.elevation, sky.sun.azimuth), static_cast<float>(std::cos(kRadius)));
  light.sunIrradiance = glm::vec4(sky.sun.irradiance, 0);
  // All of it comes from what the horizon leaves of the disc.
  const double disc = kPi * kRadius * kRadius * shader::sunDiscShare(static_cast<float>(sky.sun.elevation));
  light.sunRadiance = glm::vec4(glm::vec3(glm::dvec3(sky.sun.irradiance) / disc), 1);
  light.skyIrradiance = glm::vec4(sky.skyIrradiance, 1);
  light.rayleighExtinction = glm::vec4(shader::kRayleighScattering, shader::kRayleighHeight);
  light.mieExtinction = glm::vec4(shader::kMieExtinction * static_cast<float>(state.haze), state.hazeHeight);
  light.moonDirection = light.moonLit = glm::vec4(0, -1, 0, 0);
  light.stars = glm::vec4(0, 0, 0, 1);
  light.cloudPlace = light.cloudSun = glm::vec4(0, 0, 0, 1e9);
  return light;
}

}  // namespace sky
}  // namespace pelagic
