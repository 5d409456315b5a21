#pragma once

#include <cstdint>
#include <memory>

#include "anatomy/breathing.h"
#include "core/geometry.h"
#include "fem/body_motion.h"
#include "fem/contact_line.h"
#include "fem/contact_numbers.h"
#include "fem/node_forces.h"
#include "forces/resistance_model.h"

namespace bodkin::simulation {

// The deformable body that a needle meets in the tick, as seen by the rest of a session: the source of its contact
// points, its own motion, and the needle's effect on it.
class BodyPort : public forces::TissueBody {
 public:
  // Value of the event line_taken for a needle off the planned line (stream_points); on it -1.
  static constexpr double own_line = -2.0;

  // When a needle takes over the points of its line: as they become known, without waiting; in the ticks given by
  // set_recorded_points(); or, without a clock, each point before the needle reaches it.
  enum class PointTiming { as_known, as_recorded, in_time };
  // Before the ticks: from now on a needle meets the contact points of its own line wherever it touches the body, and
  // new ones ahead of it when it turns; the caller has to compute them (fem::ContactStream). In the last two timings
  // the tick waits for them. Null, without effect, for a resistance without contact points.
  virtual std::shared_ptr<fem::ContactLine> stream_points(PointTiming timing) {
    static_cast<void>(timing);
    return {};
  }
  // Before the ticks, and before stream_points(): from now on the body moves on its own, according to `motion`, and
  // carries the needle. False, without effect, when the resistance does not support this.
  virtual bool move_with(const std::shared_ptr<fem::BodyMotion>& motion) {
    static_cast<void>(motion);
    return false;
  }

  // From the tick's thread, as all functions below. In a tick in which the needle is outside the body, its tip at
  // `tip`: requests the points of the line along the unit vector `axis` before the needle touches the body there.
  virtual void approach(const Vec3& tip, const Vec3& axis) noexcept {
    static_cast<void>(tip);
    static_cast<void>(axis);
  }
  // In a tick of a breathing patient: tissue has moved according to `field`, and the needle is given relative to the
  // motion `of_tip` (mm) of the tissue at its tip. `field` must outlive the ticks.
  virtual void breathe(const anatomy::BreathField& field, double drawn_in, const Vec3& of_tip) noexcept {
    static_cast<void>(field);
    static_cast<void>(drawn_in);
    static_cast<void>(of_tip);
  }
  // Before a tick: changes the parameters of the contact (contact_numbers()) to these, gradually over 0.1 s; at once
  // if the needle touches nothing.
  virtual void change_numbers(const fem::ContactNumbers& numbers) noexcept = 0;
  // Last step of the body (BodyField::step) whose motion the needle has met; 0 before the first.
  virtual std::uint64_t applied_motion_step() const noexcept { return 0; }
  // In a replay, before the tick that has this event (EventKind::points_taken): its value.
  virtual void set_recorded_points(double recorded) noexcept { static_cast<void>(recorded); }
  // In a replay, before the tick that has this event (EventKind::points_coupled).
  virtual void set_recorded_coupling() noexcept {}
  // The needle's forces on the body in the last tick, by node of its mesh; none without contact.
  virtual fem::NodeForces node_forces() const noexcept = 0;
  // The needle's effect in the last tick on a probe that holds nodes of the mesh, those held when the needle's line
  // was requested: N, and N mm about the middle of these nodes. In the needle's equations these nodes do not move;
  // this is the change of the force that holds them. Zero without contact or probe.
  virtual Wrench on_held() const noexcept { return {}; }
  // mm from the needle in the body to the one in the hand, when the body is stiffer than the device can render or the
  // tip is on bone: the needle is displayed at the hand's needle minus this. 0 without contact.
  virtual Vec3 coupling_offset() const noexcept = 0;
  // LPS, mm, of the last tick: the body's own motion along the needle's shaft, as the motion of a straight line
  // (fem::EmbeddedNeedle::carried_along_shaft); breathing counts relative to its motion at the tip. Identity without
  // contact.
  virtual Pose tissue_motion() const noexcept { return Pose::Identity(); }

 protected:
  ~BodyPort() = default;
};

}  // namespace bodkin::simulation
