#pragma once

#include "forces/events.h"

namespace bodkin::simulation {

// The hub of a needle inserted to its full length lies on the skin and stops. Further pushing compresses the skin
// under it, as a spring along the needle does: passive, and never pulling.
class HubStop {
 public:
  // `length`: of the needle, hub to tip, mm, above 0. `stiffness`: the largest that the device renders, N/mm.
  HubStop(double length, double stiffness) noexcept : length_(length), stiffness_(stiffness) {}

  // A new insertion.
  void begin() noexcept { touches_ = false; }
  // The force that pushes the needle out, N, at `depth` mm of the tip along the insertion line. `held`: N/mm, the
  // part of the device's stiffness used by the tissue; the stop uses the rest, and never less than half. Each contact
  // of the hub with the skin is an event hub_contact.
  double step(double depth, double held, anatomy::TissueId tissue, forces::TickEvents& events) noexcept;

 private:
  double length_, stiffness_;
  bool touches_ = false;
};

}  // namespace bodkin::simulation
