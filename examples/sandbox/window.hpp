/// A window of GLFW's with a Vulkan surface.
#pragma once

#include <GLFW/glfw3.h>

#include <memory>
#include <vector>
#include <vulkan/vulkan.hpp>

namespace sandbox {

/// One at a time. Throws a common::Failure when there is no display.
class Window {
 public:
  Window(vk::Extent2D extent, const char* title);
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  ~Window();

  GLFWwindow* handle() const { return window_; }
  /// Instance extensions that a surface needs; the strings live as long as GLFW.
  std::vector<const char*> instanceExtensions() const;
  vk::UniqueSurfaceKHR createSurface(vk::Instance instance) const;
  /// In pixels; zero when minimised.
  vk::Extent2D extent() const;
  bool closing() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }

 private:
  GLFWwindow* window_ = nullptr;
};

}  // namespace sandbox
