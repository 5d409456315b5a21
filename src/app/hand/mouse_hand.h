#pragma once

#include "core/geometry.h"
#include "haptics/simulated_hand.h"

namespace bodkin::app {

// The needle pose requested by the person, LPS: on the line through `at` along `axis`, `depth` mm beyond `at`.
struct HandGoal {
  Vec3 at = Vec3::Zero();     // on the skin
  Vec3 axis = Vec3::UnitY();  // unit, into the body
  double turn = 0.0;          // rad about the axis, clockwise when looking along it
  double depth = 0.0;         // mm; negative: above the skin
  double speed = 30.0;        // mm/s along the axis, limit
  bool is_down = false;       // false: the hand waits above the skin
  bool is_braced = false;     // against the patient
  bool ended = false;         // the window has closed the session
};

// The state of the hand, for the window.
struct HandReport {
  Pose meant = Pose::Identity();   // LPS, commanded pose, without the resistance
  Pose needle = Pose::Identity();  // LPS, actual pose
  double depth = 0.0;              // mm of the needle beyond HandGoal::at
  bool is_on_line = false;         // it is on the line of the newest goal
};

// The pose of a needle rotated about its axis.
Pose turned_needle(const Vec3& tip, const Vec3& axis, double turn) noexcept;

// A hand that follows a goal: it waits above the skin, follows the pointer there, descends along its line and then
// moves only along that line. The commanded position moves at a human pace; the needle is attached to it by a spring
// of 1 N/mm along the axis, so a tissue's resistance holds it back by 1 mm per N. A hand braced against the patient,
// as for the last millimetres of an epidural, has a spring of 5 N/mm and a heavy damper: at a puncture, the needle
// advances only a fifth as far and slowly. Across the axis it does not yield.
//
//   s' = v,  v' = (u - v) / T,  u = (depth - s) / (2 T) within the speed       critically damped for a goal at rest
//
// The line follows a changed goal only above the skin; only the axis does, about `at`, at small depths too. Nothing
// here allocates.
class MouseHand {
 public:
  static constexpr double waiting = 30.0;   // mm above the skin
  static constexpr double shallow = 10.0;   // mm, largest depth at which the axis may turn
  static constexpr double stiffness = 1.0;  // N/mm
  static constexpr double braced_stiffness = 5.0;
  static constexpr double smoothing = 0.03;      // s, T
  static constexpr double air_speed = 250.0;     // mm/s along the axis above the skin
  static constexpr double aiming_speed = 500.0;  // mm/s across it
  static constexpr double turning_speed = 1.5;   // rad/s
  static constexpr double twirling_speed = 6.0;  // rad/s about the axis

  explicit MouseHand(double dt);

  // At rest, waiting above the skin of `goal`.
  void start(const HandGoal& goal) noexcept;
  // One tick under the force on the hand (N, LPS). Returns the needle's pose.
  const Pose& step(const HandGoal& goal, const Vec3& force) noexcept;
  const Vec3& velocity() const noexcept { return hand_.velocity(); }
  const HandReport& report() const noexcept { return report_; }

 private:
  void follow_line(const HandGoal& goal) noexcept;
  void brace(bool on) noexcept;
  void turn_towards(const Vec3& axis) noexcept;

  double dt_;
  haptics::SimulatedHand hand_;
  Vec3 at_ = Vec3::Zero(), axis_ = Vec3::UnitY();
  double place_ = -waiting, speed_ = 0.0;  // mm beyond at_, mm/s
  double turn_ = 0.0;                      // rad
  bool braced_ = false;
  HandReport report_;
};

}  // namespace bodkin::app
