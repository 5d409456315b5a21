#pragma once

#include "core/geometry.h"
#include "haptics/simulated_hand.h"

namespace bodkin::app {

// Where the person wants the needle, LPS: on the line through `at` along `axis`, `depth` mm beyond `at`.
struct HandWish {
  Vec3 at = Vec3::Zero();     // on the skin
  Vec3 axis = Vec3::UnitY();  // unit, into the body
  double turn = 0.0;          // rad about the axis, clockwise for who looks along it
  double depth = 0.0;         // mm; negative: above the skin
  double speed = 30.0;        // mm/s along the axis at most
  bool is_down = false;       // false: the hand waits above the skin
  bool is_braced = false;     // against the patient
  bool ended = false;         // the window has closed the session
};

// What the hand has come to, for the window.
struct HandReport {
  Pose meant = Pose::Identity();   // LPS, where the hand means the needle to be, without the resistance
  Pose needle = Pose::Identity();  // LPS, where it is
  double depth = 0.0;              // mm of the needle beyond HandWish::at
  bool is_on_line = false;         // it is on the line of the newest wish
};

// The pose of a needle that is turned about its axis.
Pose turned_needle(const Vec3& tip, const Vec3& axis, double turn) noexcept;

// A hand that puts a needle where a wish says: it waits above the skin, follows the pointer there, goes down its line
// and then moves along that line only. What it means moves at a human pace; the needle hangs on it by a spring of
// 1 N/mm along the axis, so a tissue that resists holds it back by 1 mm per N. A hand that is braced against the
// patient, as for the last millimetres of an epidural, has a spring of 5 N/mm and a heavy damper: where the tissue
// gives way, the needle goes on by a fifth as far and slowly. Across the axis it does not yield.
//
//   s' = v,  v' = (u - v) / T,  u = (depth - s) / (2 T) within the speed       critically damped for a wish at rest
//
// The line follows another wish only above the skin; the axis alone, about `at`, where the needle is shallow too.
// Nothing here allocates.
class MouseHand {
 public:
  static constexpr double waiting = 30.0;   // mm above the skin
  static constexpr double shallow = 10.0;   // mm, the deepest at which the axis may turn
  static constexpr double stiffness = 1.0;  // N/mm
  static constexpr double braced_stiffness = 5.0;
  static constexpr double smoothing = 0.03;      // s, T
  static constexpr double air_speed = 250.0;     // mm/s along the axis above the skin
  static constexpr double aiming_speed = 500.0;  // mm/s across it
  static constexpr double turning_speed = 1.5;   // rad/s
  static constexpr double twirling_speed = 6.0;  // rad/s about the axis

  explicit MouseHand(double dt);

  // At rest, waiting above the skin of `wish`.
  void start(const HandWish& wish) noexcept;
  // One tick under the force on the hand (N, LPS). Returns the needle's pose.
  const Pose& step(const HandWish& wish, const Vec3& force) noexcept;
  const Vec3& velocity() const noexcept { return hand_.velocity(); }
  const HandReport& report() const noexcept { return report_; }

 private:
  void follow_line(const HandWish& wish) noexcept;
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
