/// A camera that flies: W A S D, Q down, E up, Shift faster; the right mouse button turns it.
#pragma once

#include <common/view.hpp>

#include "window.hpp"

namespace sandbox {

class FlyCamera {
 public:
  explicit FlyCamera(const common::View& view);

  /// Moves by what is held down for `seconds`. Keys and mouse are ignored where the controls want them.
  void move(const Window& window, double seconds, bool keys, bool mouse);
  pelagic::Camera camera(double aspect) const;

  glm::dvec3 position;  ///< [m]
  double fov;           ///< Full vertical angle [degrees].

 private:
  glm::dvec3 forward() const;

  double yaw_;    ///< From +x turning to +z [rad].
  double pitch_;  ///< Above the horizontal [rad].
  glm::dvec2 cursor_{};
};

}  // namespace sandbox
