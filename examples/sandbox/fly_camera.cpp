#include "fly_camera.hpp"

#include <algorithm>
#include <cmath>

namespace sandbox {
namespace {

constexpr double kSpeed = 8;        // [m/s]
constexpr double kFaster = 12;      // with Shift
constexpr double kTurn = 0.003;     // [rad] per pixel of the mouse
constexpr double kSteepest = 1.55;  // [rad], short of straight up, where left and right are lost
constexpr double kLowest = -1e4;    // [m], range of pelagic::Camera::position
constexpr double kHighest = 1e5;    // [m]
constexpr double kFarthest = 1e9;   // [m]

}  // namespace

FlyCamera::FlyCamera(const common::View& view) : position(view.position), fov(view.fov) {
  const glm::dvec3 ahead = view.lookAt - view.position;
  yaw_ = std::atan2(ahead.z, ahead.x);
  pitch_ = std::clamp(std::atan2(ahead.y, std::hypot(ahead.x, ahead.z)), -kSteepest, kSteepest);
}

glm::dvec3 FlyCamera::forward() const {
  return {std::cos(pitch_) * std::cos(yaw_), std::sin(pitch_), std::cos(pitch_) * std::sin(yaw_)};
}

void FlyCamera::move(const Window& window, double seconds, bool keys, bool mouse) {
  GLFWwindow* handle = window.handle();
  glm::dvec2 cursor{};
  glfwGetCursorPos(handle, &cursor.x, &cursor.y);
  if (mouse && glfwGetMouseButton(handle, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS) {
    yaw_ += kTurn * (cursor.x - cursor_.x);
    pitch_ = std::clamp(pitch_ - kTurn * (cursor.y - cursor_.y), -kSteepest, kSteepest);
  }
  cursor_ = cursor;
  if (!keys) return;
  const auto held = [&](int key) { return glfwGetKey(handle, key) == GLFW_PRESS ? 1.0 : 0.0; };
  const glm::dvec3 right(-std::sin(yaw_), 0, std::cos(yaw_));
  const glm::dvec3 step = forward() * (held(GLFW_KEY_W) - held(GLFW_KEY_S)) +
                          right * (held(GLFW_KEY_D) - held(GLFW_KEY_A)) +
                          glm::dvec3(0, held(GLFW_KEY_E) - held(GLFW_KEY_Q), 0);
  const double speed = kSpeed * (held(GLFW_KEY_LEFT_SHIFT) > 0 ? kFaster : 1.0);
  position = glm::clamp(position + step * speed * seconds, {-kFarthest, kLowest, -kFarthest},
                        {kFarthest, kHighest, kFarthest});
}

pelagic::Camera FlyCamera::camera(double aspect) const {
  return common::cameraOf({position, position + forward(), fov}, aspect);
}

}  // namespace sandbox
