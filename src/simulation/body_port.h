#pragma once

#include <cstddef>
#include <memory>

#include "anatomy/case.h"
#include "core/geometry.h"
#include "fem/contact_line.h"
#include "fem/node_forces.h"

namespace bodkin::simulation {

// The deformable body that a needle meets in the tick, as the rest of a session sees it: where more of it comes from,
// and what the needle does to it.
class BodyPort {
 public:
  // Including the one that the patient came with.
  static constexpr std::size_t most_corridors = 32;
  // Value of the event corridor_taken for a needle on its own line (stream_points).
  static constexpr double own_line = -2.0;

  // From one thread other than the tick's: another corridor, for the next needle that touches the body. False, and
  // nothing done, when there are `most_corridors`. Throws InputError for a corridor without a body.
  virtual bool add_corridor(const anatomy::PreparedCorridor& corridor) = 0;
  // From the same thread: the first corridor about another state of the body (PreparedCorridor::state), for the next
  // needle that touches the body and, if it can be transferred, for one that is in. False, and nothing done, when the
  // resistance cannot use one. Throws InputError for one in which there is nothing to feel.
  virtual bool refresh_corridor(const anatomy::PreparedCorridor& corridor) = 0;

  // Before the ticks: from now on a needle that touches the body where no prepared line is within 1.5 mm meets the
  // contact points of its own line, as they become known there; someone has to compute them (fem::ContactStream).
  // `as_recorded`: it takes points as take_points() says, and waits for them. Null, and nothing done, for a
  // resistance without contact points.
  virtual std::shared_ptr<fem::ContactLine> stream_points(bool as_recorded) = 0;

  // From the tick's thread, in a tick in which the needle is outside the body, its tip at `tip`: asks for the points
  // of the line along the unit vector `axis` before the needle touches the body there.
  virtual void approach(const Vec3& tip, const Vec3& axis) noexcept = 0;
  // Of a recording, before the tick that has this event (EventKind::points_taken): its value.
  virtual void take_points(double recorded) noexcept = 0;
  // From the tick's thread, as all below: from the next contact on the needle meets the body at rest, whatever was or
  // will be refreshed.
  virtual void stay_at_rest() noexcept = 0;
  // The needle's forces on the body in the last tick, by node of its mesh; none without contact.
  virtual fem::NodeForces node_forces() const noexcept = 0;
  // mm from the needle in the body to the one in the hand, where the body is stiffer than the device can render or
  // bone is in the way: what is drawn is the hand's needle less this. 0 without contact.
  virtual Vec3 needle_ahead() const noexcept = 0;

 protected:
  ~BodyPort() = default;
};

}  // namespace bodkin::simulation
