#pragma once

#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/parameter.h"

namespace bodkin::training {

// Thresholds of the metrics of a session. A procedure may state its own; old sessions are then measured with them
// too.
struct Thresholds {
  double outside_time = 0.5;      // s
  double outside_distance = 5.0;  // mm
  double rest_time = 0.5;         // s
  double rest_speed = 1.0;        // mm/s
  double same_rest = 1.0;         // mm
  double stop_speed = 1.0;        // mm/s
  double retreat = 5.0;           // mm
  double redirection = 3.0;       // deg
  double reentry = 1.0;           // mm
  double action_speed = 5.0;      // mm/s
  double action_turn = 10.0;      // deg/s
  double action_time = 0.2;       // s
  double quick_speed = 50.0;      // mm/s
  double quick_turn = 50.0;       // deg/s
  double lift = 0.5;              // mm
  double twirl = 10.0;            // deg
  double tip_in_slice = 2.0;      // mm
  double target_in_slice = 5.0;   // mm
  double guide_angle = 15.0;      // deg
  double guide_offset = 10.0;     // mm

  bool operator==(const Thresholds&) const = default;

  template <typename S = Thresholds>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"outside_s", &S::outside_time, Range{0.0, 60.0}, "s",
                  "a needle that was outside for longer begins another insertion", Origin::choice},
        Parameter{"outside_mm", &S::outside_distance, Range{0.0, 100.0}, "mm",
                  "the same of one that was farther outside", Origin::choice},
        Parameter{"rest_s", &S::rest_time, Range{0.4, 10.0}, "s", "a rest of the tip lasts at least so long",
                  Origin::choice},
        Parameter{"rest_mm_per_s", &S::rest_speed, Range{0.1, 10.0}, "mm/s",
                  "a tip rests whose mean over 0.2 s moves more slowly", Origin::choice},
        Parameter{"same_rest_mm", &S::same_rest, Range{0.0, 10.0}, "mm",
                  "rests within it of the deepest are as deep: the last one is the final position", Origin::choice},
        Parameter{"stop_mm_per_s", &S::stop_speed, Range{0.1, 10.0}, "mm/s",
                  "a tip that is slower inwards has stopped after a puncture", Origin::choice},
        Parameter{"retreat_mm", &S::retreat, Range{0.5, 50.0}, "mm",
                  "a needle that was drawn back by more may be redirected, and is on another way", Origin::choice},
        Parameter{"redirection_deg", &S::redirection, Range{0.1, 45.0}, "deg",
                  "it was redirected where its axis then turned by more", Origin::choice},
        Parameter{"reentry_mm", &S::reentry, Range{0.0, 50.0}, "mm",
                  "travel outside what must not be entered, after which an entry counts again", Origin::choice},
        Parameter{"action_mm_per_s", &S::action_speed, Range{0.1, 1000.0}, "mm/s",
                  "a needle with a faster tip is in action (TrainUS)", Origin::literature},
        Parameter{"action_deg_per_s", &S::action_turn, Range{0.1, 1000.0}, "deg/s",
                  "a needle that turns faster is in action (TrainUS)", Origin::literature},
        Parameter{"action_s", &S::action_time, Range{0.0, 5.0}, "s",
                  "a change between rest and action, or to a quick movement, lasts longer (PerkTutor, TrainUS)",
                  Origin::literature},
        Parameter{"quick_mm_per_s", &S::quick_speed, Range{0.1, 1000.0}, "mm/s",
                  "a faster movement of the tip is quick (PerkTutor)", Origin::literature},
        Parameter{"quick_deg_per_s", &S::quick_turn, Range{0.1, 1000.0}, "deg/s",
                  "a faster turn of the needle is quick (PerkTutor)", Origin::literature},
        Parameter{"lift_mm", &S::lift, Range{0.1, 20.0}, "mm",
                  "lifting and thrusting turn by at least so much; less is tremor", Origin::choice},
        Parameter{"twirl_deg", &S::twirl, Range{1.0, 180.0}, "deg",
                  "twirling turns back by at least so much; less is tremor", Origin::choice},
        Parameter{"tip_in_slice_mm", &S::tip_in_slice, Range{0.1, 50.0}, "mm",
                  "a tip that is no farther from the ultrasound slice is seen", Origin::choice},
        Parameter{"target_in_slice_mm", &S::target_in_slice, Range{0.1, 50.0}, "mm",
                  "the same of the target and of landmarks (PerkTutor)", Origin::literature},
        Parameter{"guide_deg", &S::guide_angle, Range{1.0, 90.0}, "deg",
                  "greatest angle of a picture, and of a needle at the skin, to the planned path (TrainUS)",
                  Origin::literature},
        Parameter{"guide_mm", &S::guide_offset, Range{0.1, 100.0}, "mm",
                  "greatest distance of a tip at the skin from the line of the planned path (TrainUS)",
                  Origin::literature}};
  }
};

// Name and value of those that differ from the default, in the order of the table.
std::vector<std::pair<std::string_view, double>> own_thresholds(const Thresholds& thresholds);

}  // namespace bodkin::training
