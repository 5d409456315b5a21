#pragma once

#include <limits>
#include <tuple>

#include "core/geometry.h"
#include "core/settings_check.h"
#include "haptics/device.h"

namespace bodkin::haptics {

// Limits of HandGuard. guard_settings() derives them from a device's report; the other numbers are choices of this
// project (docs/safety.md gives reasons).
struct GuardSettings {
  double dt = 0.001;
  double peak_force = 0.0;
  double continuous_force = 0.0;
  double peak_torque = 0.0;
  double user_force = std::numeric_limits<double>::infinity();
  Vec3 workspace_low = Vec3::Zero();   // mm
  Vec3 workspace_high = Vec3::Zero();  // mm; both zero: unknown, no guard
  double slew = 500.0;
  double torque_slew = 20000.0;
  double ramp_time = 1.0;
  double fade_time = 0.020;
  double arming_force = 0.3;
  double arming_patience = 2.0;
  double speed_limit = 1000.0;
  double frozen_time = 0.5;
  double oscillation_amplitude = 0.05;
  double stiffness = 1.0;
  double damping = 0.002;
  double thermal_time = 30.0;
  double delay = 0.0;                // only the transport
  bool sent_with_next_tick = false;  // the loop is ours: a command leaves with the exchange of the next tick

  template <typename S = GuardSettings>
  static constexpr auto parameters() {
    constexpr Range not_negative = from_to_below(0.0, unbounded), positive = {0.0, unbounded, false, false};
    return std::tuple{
        Parameter{"period_s", &S::dt, Range{0.00025, 0.005}, "s", "nominal", Origin::choice},
        Parameter{"peak_force_N", &S::peak_force, not_negative, "N", "0: the device renders no force",
                  Origin::choice},
        Parameter{"continuous_force_N", &S::continuous_force, not_negative, "N", "at most the peak force",
                  Origin::choice},
        Parameter{"peak_torque_N_mm", &S::peak_torque, not_negative, "N mm", "0: it renders no torque",
                  Origin::choice},
        Parameter{"user_force_N", &S::user_force, Range{0.0, unbounded}, "N", "that the user wants at most",
                  Origin::choice},
        Parameter{"slew_N_per_s", &S::slew, positive, "N/s", "by which a force may rise or turn", Origin::choice},
        Parameter{"torque_slew_N_mm_per_s", &S::torque_slew, positive, "N mm/s", "the same of a torque",
                  Origin::choice},
        Parameter{"ramp_time_s", &S::ramp_time, positive, "s", "from armed to full force", Origin::choice},
        Parameter{"fade_time_s", &S::fade_time, above(0.0, 0.020), "s", "to zero where the device itself is sound",
                  Origin::choice},
        Parameter{"arming_force_N", &S::arming_force, Range{0.0, unbounded}, "N",
                  "that may wait at most when it is armed", Origin::choice},
        Parameter{"arming_patience_s", &S::arming_patience, positive, "s", "for which a wish to arm stands",
                  Origin::choice},
        Parameter{"speed_limit_mm_per_s", &S::speed_limit, positive, "mm/s", "of the hand", Origin::choice},
        Parameter{"frozen_time_s", &S::frozen_time, Range{0.0, unbounded}, "s",
                  "of unchanged readings under force; 0: no guard", Origin::choice},
        Parameter{"oscillation_amplitude_mm", &S::oscillation_amplitude, positive, "mm",
                  "from turning point to turning point", Origin::choice},
        Parameter{"stiffness_N_per_mm", &S::stiffness, positive, "N/mm", "that the device renders stably",
                  Origin::choice},
        Parameter{"damping_N_s_per_mm", &S::damping, not_negative, "N s/mm", "that the device renders stably",
                  Origin::choice},
        Parameter{"thermal_time_s", &S::thermal_time, positive, "s", "over which the motors average their load",
                  Origin::choice},
        Parameter{"delay_s", &S::delay, Range{0.0, 0.02}, "s", "from sending a force to the force at the hand",
                  Origin::choice}};
  }
  template <typename S = GuardSettings>
  static constexpr auto relations() {
    return std::tuple{
        AtMost{&S::continuous_force, &S::peak_force},
        Relation<S>{[](const S& s) { return s.peak_force == 0.0 || s.continuous_force > 0.0; },
                    "continuous_force_N is 0 N, expected more than 0 N for a device that renders forces"},
        Relation<S>{[](const S& s) {
                      const Vec3 size = s.workspace_high - s.workspace_low;
                      const bool unknown = s.workspace_high.isZero(0.0) && s.workspace_low.isZero(0.0);
                      return size.allFinite() && (unknown || size.minCoeff() > 0.0);
                    },
                    "a side of the workspace is not longer than 0 mm, expected a box, or nothing"}};
  }
};

// Limits for a device: nine tenths of its peaks, its continuous force (15 % of the peak if unknown: less than that of
// any device in share/bodkin/devices.csv), its workspace, amplitudes that its encoders can distinguish from noise,
// its delay. Late damping damps less, so its bound falls as 2 T / (2 T + delay), T the period. `rate`: Hz at which
// the guard is called.
GuardSettings guard_settings(const DeviceAbilities& abilities, double rate);

}  // namespace bodkin::haptics
