#include "window.hpp"

#include <common/failure.hpp>
#include <string>

namespace sandbox {
namespace {

[[noreturn]] void fail(const std::string& what) {
  const char* reason = nullptr;
  glfwGetError(&reason);
  throw common::Failure(common::ExitCode::device, what + (reason ? std::string(": ") + reason : ""));
}

}  // namespace

Window::Window(vk::Extent2D extent, const char* title) {
  if (glfwInit() != GLFW_TRUE) fail("cannot open a window");
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  window_ = glfwCreateWindow(static_cast<int>(extent.width), static_cast<int>(extent.height), title, nullptr, nullptr);
  if (!window_) {
    glfwTerminate();
    fail("cannot open a window");
  }
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

std::vector<const char*> Window::instanceExtensions() const {
  std::uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (!names) fail("this system's Vulkan cannot draw into windows");
  return {names, names + count};
}

vk::UniqueSurfaceKHR Window::createSurface(vk::Instance instance) const {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  if (glfwCreateWindowSurface(instance, window_, nullptr, &surface) != VK_SUCCESS) fail("cannot create a surface");
  return vk::UniqueSurfaceKHR(surface, instance);
}

vk::Extent2D Window::extent() const {
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

}  // namespace sandbox
