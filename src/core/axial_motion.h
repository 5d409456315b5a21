#pragma once

namespace bodkin {

// The motion along the needle, as the force laws need it.
struct AxialMotion {
  double depth = 0.0;     // mm, tip beyond the undisturbed skin, positive inwards
  double velocity = 0.0;  // mm/s, positive inwards
  int direction = 0;      // -1, 0 or +1; flips only at speeds above the noise of the input
  bool stopped = true;    // at rest for the dwell time, or the velocity has just changed sign
};

}  // namespace bodkin
