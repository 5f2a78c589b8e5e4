#include "view.hpp"

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "failure.hpp"

namespace common {
namespace {

/// The ranges of pelagic::Camera::position.
glm::dvec3 parsePoint(const std::string& where, const std::string& text) {
  const glm::dvec3 point = parseVector(where, text, {-1e9, 1e9, "m"});
  if (point.y < -1e4 || point.y > 1e5) refuse(where, text, "heights Y from -10000 to 100000 m");
  return point;
}

Field pointField(std::string name, std::string help, glm::dvec3& target) {
  return {std::move(name), "X,Y,Z", std::move(help) + ", X and Z -1e9 to 1e9 m, height Y -10000 to 100000 m",
          [&target](const std::string& where, const std::vector<std::string>& texts) {
            target = parsePoint(where, texts.front());
          }};
}

VkExtent2D parseExtent(const std::string& where, const std::string& text) {
  const Range range{1, 16384, "pixels"};
  const std::vector<std::string> sides = split(text, 'x');
  if (sides.size() != 2) refuse(where, text, "WxH, each " + describe(range));
  const auto side = [&](const std::string& part) {
    const double pixels = parsePart(where, text, part, "WxH, each", range);
    if (pixels != std::floor(pixels)) refuse(where, text, "WxH, each a whole number, " + describe(range));
    return static_cast<std::uint32_t>(pixels);
  };
  return {side(sides[0]), side(sides[1])};
}

}  // namespace

Field extentField(std::string name, const std::string& help, VkExtent2D& extent) {
  return {std::move(name), "WxH", help + ", each 1 to 16384 pixels",
          [&extent](const std::string& where, const std::vector<std::string>& texts) {
            extent = parseExtent(where, texts.front());
          }};
}

Fields viewFields(View& view) {
  return {
      pointField("camera", "Where the camera stands", view.position),
      pointField("look-at", "What it looks at", view.lookAt),
      numberField("fov", "DEG", "Full vertical angle of view", {0.1, 170, "degrees"}, view.fov),
  };
}

glm::mat4 projection(double fov, double aspect) {
  const double f = 1 / std::tan(fov / 2);
  glm::mat4 matrix(0);
  matrix[0][0] = static_cast<float>(f / aspect);
  matrix[1][1] = static_cast<float>(-f);
  matrix[2][3] = -1;          // w = distance along the axis
  matrix[3][2] = kNearPlane;  // depth = near / w
  return matrix;
}

glm::mat3 rotationToward(const glm::dvec3& forward) {
  const glm::dvec3 ahead = glm::normalize(forward);
  const bool steep = std::hypot(ahead.x, ahead.z) < 1e-6;
  const glm::dvec3 head = steep ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(ahead, head));
  const glm::dvec3 up = glm::cross(right, ahead);
  return glm::mat3(glm::transpose(glm::dmat3(right, up, -ahead)));
}

pelagic::Camera cameraOf(const View& view, double aspect) {
  if (glm::distance(view.lookAt, view.position) < 1e-6) {
    throw Failure(ExitCode::badInput, "--look-at is the place of --camera, allowed: any other point");
  }
  pelagic::Camera camera;
  camera.position = view.position;
  camera.rotation = rotationToward(view.lookAt - view.position);
  camera.projection = projection(glm::radians(view.fov), aspect);
  return camera;
}

}  // namespace common
