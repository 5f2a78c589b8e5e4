/// The controls: every parameter of the scene, live.
#pragma once

#include <common/scene.hpp>
#include <pelagic/timings.hpp>

namespace sandbox {

/// What the user has touched.
struct Changes {
  bool sea = false;
  bool layout = false;  ///< Cascades, size or loop: the simulation has to be built anew.
  bool sky = false;
  bool water = false;
};

/// How time passes.
struct Clock {
  double time = 0;    ///< [s]
  double speed = 1;   ///< Seconds of the sea per second.
  double change = 2;  ///< Over which a new sea takes over [s].
};

/// A measured pass, kept longer than its frame.
struct PassTime {
  std::string name;
  double milliseconds = 0;
};

/// Draws the controls of `scene` and `clock` and what became of the sea.
Changes drawPanel(common::Scene& scene, Clock& clock, double& fov, const pelagic::SeaReport& report,
                  const std::vector<PassTime>& passes);

}  // namespace sandbox
