#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>

#include "core/geometry.h"
#include "core/parameter.h"
#include "core/settings_check.h"

namespace bodkin::anatomy {

// Breathing of a patient, and the motion of the tissue with it.
//
// A point that lies at X after expiration lies at
//   x = X + b m w(X),   w = (1 - |x - c|^2 / R^2)^2 within the distance R of the centre c, 0 outside,
// where b is the depth of inspiration, 0 to 1, and m the motion of the centre. With the period T
//   b = sin^2n(pi t / T):
// the greater n, the longer the pause after expiration (Lujan et al. 1999, eq. 1, there begun after inspiration).
struct Breathing {
  double rate = 14.0;
  Vec3 motion = Vec3(0.0, -3.0, -10.0);
  Vec3 centre = Vec3::Zero();
  double radius = 80.0;
  int pause = 2;
  double longest_hold = 25.0;

  template <typename S = Breathing>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"rate_per_min", &S::rate, Range{2.0, 60.0}, "1/min", "breaths a minute", Origin::choice},
        Component{"right_left_mm", &S::motion, 0, Range{-60.0, 60.0}, "mm",
                  "motion of the centre as breath is drawn in, to the patient's left", Origin::choice},
        Component{"front_back_mm", &S::motion, 1, Range{-60.0, 60.0}, "mm",
                  "the same, to the back; the front rises, so it is negative", Origin::choice},
        Component{"feet_head_mm", &S::motion, 2, Range{-60.0, 60.0}, "mm",
                  "the same, towards the head; organs below the diaphragm go down by 5 to 25 mm, so it is negative "
                  "(Keall et al. 2006)",
                  Origin::literature},
        Component{"x_mm", &S::centre, 0, Range{-1e5, 1e5}, "mm", "centre, LPS: tissue there moves most",
                  Origin::choice},
        Component{"y_mm", &S::centre, 1, Range{-1e5, 1e5}, "mm", "the same", Origin::choice},
        Component{"z_mm", &S::centre, 2, Range{-1e5, 1e5}, "mm", "the same", Origin::choice},
        Parameter{"radius_mm", &S::radius, Range{20.0, 500.0}, "mm",
                  "about the centre; tissue farther away stands still", Origin::choice},
        Parameter{"pause", &S::pause, Range{1.0, 6.0}, "",
                  "how long it pauses breathed out: n of sin^2n (Lujan et al. 1999)", Origin::literature},
        Parameter{"longest_hold_s", &S::longest_hold, Range{1.0, 120.0}, "s",
                  "that the patient holds the breath when asked to", Origin::choice}};
  }
  // A larger motion would fold the tissue: |grad w| is at most 1.54 / R.
  static constexpr auto relations() {
    return std::tuple{Relation<Breathing>{
        [](const Breathing& it) { return it.motion.norm() <= it.radius / 3.0; },
        "motion is longer than a third of radius_mm, expected less, so that tissue does not fold; make radius_mm "
        "larger"}};
  }
};

// The state of a breathing patient between two ticks.
struct BreathState {
  std::uint64_t phase = 0, held = 0;  // ticks since the breath began; ticks for which it has been held
};

// The breathing of a patient over time: advanced once a tick, so that a recording reproduces the same breaths. Starts
// after expiration.
class BreathClock {
 public:
  // `dt`: s.
  BreathClock(const Breathing& breathing, double dt) noexcept;

  // Advances by one tick. `hold`: the patient is asked to hold the breath: breathes out first, holds for
  // `longest_hold`, then takes one breath and holds again. Returns the depth of inspiration, 0 to 1.
  double step(bool hold) noexcept;
  double drawn_in() const noexcept { return drawn_in_; }
  // Whether the breath is held now.
  bool holds() const noexcept { return holds_; }
  void reset() noexcept { set({}); }
  const BreathState& moment() const noexcept { return now_; }
  // Continues from a state of a clock of the same patient.
  void set(const BreathState& moment) noexcept;

 private:
  double drawn_in_at(std::uint64_t phase) const noexcept;

  std::uint64_t period_, longest_hold_;  // ticks
  int pause_;
  BreathState now_;
  bool holds_ = false;
  double drawn_in_ = 0.0;
};

// The displacement of tissue by breathing.
class BreathField {
 public:
  explicit BreathField(const Breathing& breathing) noexcept
      : motion_(breathing.motion), centre_(breathing.centre), radius_squared_(breathing.radius * breathing.radius) {}

  // mm, displacement of the point that lies at `material` after expiration; `drawn_in`: 0 to 1.
  Vec3 moved(const Vec3& material, double drawn_in) const noexcept { return drawn_in * weight(material) * motion_; }
  // Position after expiration of the point that now lies at `place`; exact to 1e-9 mm.
  Vec3 material(const Vec3& place, double drawn_in) const noexcept;
  // w, 0 to 1.
  double weight(const Vec3& material) const noexcept;
  const Vec3& motion() const noexcept { return motion_; }

 private:
  Vec3 motion_, centre_;
  double radius_squared_;
};

}  // namespace bodkin::anatomy
