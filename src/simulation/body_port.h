#pragma once

#include <cstdint>
#include <memory>

#include "anatomy/breathing.h"
#include "core/geometry.h"
#include "fem/body_motion.h"
#include "fem/contact_line.h"
#include "fem/contact_numbers.h"
#include "fem/node_forces.h"

namespace bodkin::simulation {

// The deformable body that a needle meets in the tick, as the rest of a session sees it: where more of it comes from,
// how it moves by itself, and what the needle does to it.
class BodyPort {
 public:
  // Value of the event line_taken for a needle beside the planned line (stream_points); on it -1.
  static constexpr double own_line = -2.0;

  // When a needle takes the points of its line: as they become known, without waiting; in the ticks that
  // take_points() says; or, where nothing goes by the clock, each before the needle reaches it.
  enum class PointTiming { as_known, as_recorded, in_time };
  // Before the ticks: from now on a needle meets the contact points of its own line wherever it touches the body, and
  // others ahead of it when it turns; someone has to compute them (fem::ContactStream). In the last two timings it
  // waits for them. Null, and nothing done, for a resistance without contact points.
  virtual std::shared_ptr<fem::ContactLine> stream_points(PointTiming timing) {
    static_cast<void>(timing);
    return {};
  }
  // Before the ticks, and before stream_points(): the body moves by itself from now on, as `motion` says, and takes
  // the needle along. False, and nothing done, when the resistance knows no such motion.
  virtual bool move_with(const std::shared_ptr<fem::BodyMotion>& motion) {
    static_cast<void>(motion);
    return false;
  }

  // From the tick's thread, as all below. In a tick in which the needle is outside the body, its tip at `tip`: asks
  // for the points of the line along the unit vector `axis` before the needle touches the body there.
  virtual void approach(const Vec3& tip, const Vec3& axis) noexcept {
    static_cast<void>(tip);
    static_cast<void>(axis);
  }
  // In a tick of a patient who breathes: tissue has moved as `field` says, and the needle is given with `of_tip` (mm)
  // taken off, the motion of the tissue at its tip. `field` must outlive the ticks.
  virtual void breathe(const anatomy::BreathField& field, double drawn_in, const Vec3& of_tip) noexcept {
    static_cast<void>(field);
    static_cast<void>(drawn_in);
    static_cast<void>(of_tip);
  }
  // Before a tick: changes the parameters of the contact (contact_numbers()) to these, gradually over 0.1 s; at once
  // where the needle touches nothing.
  virtual void change_numbers(const fem::ContactNumbers& numbers) noexcept = 0;
  // Step of the body (BodyField::step) whose motion the needle has met last; 0 before the first.
  virtual std::uint64_t motion_taken() const noexcept { return 0; }
  // Of a recording, before the tick that has this event (EventKind::points_taken): its value.
  virtual void take_points(double recorded) noexcept { static_cast<void>(recorded); }
  // Of a recording, before the tick that has this event (EventKind::points_coupled).
  virtual void take_coupling() noexcept {}
  // The needle's forces on the body in the last tick, by node of its mesh; none without contact.
  virtual fem::NodeForces node_forces() const noexcept = 0;
  // What the needle did in the last tick to a probe that holds nodes of the mesh, those that were held when the
  // needle's line was asked for: N, and N mm about the middle of these nodes. The needle's equations have them held,
  // so that it is what these take to hold them. Zero without contact or probe.
  virtual Wrench on_held() const noexcept { return {}; }
  // mm from the needle in the body to the one in the hand, where the body is stiffer than the device can render or
  // bone is in the way: what is drawn is the hand's needle less this. 0 without contact.
  virtual Vec3 needle_ahead() const noexcept = 0;
  // LPS, mm, of the last tick: how the body has moved by itself along the needle's shaft, as the motion of a straight
  // line (fem::EmbeddedNeedle::carried_along_shaft); of breath what it is more than at the tip. None without contact.
  virtual Pose tissue_motion() const noexcept { return Pose::Identity(); }

 protected:
  ~BodyPort() = default;
};

}  // namespace bodkin::simulation
