#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/straight_motion.h"

namespace bodkin::study {

// One step of a motion along a straight path.
enum class MotionGoal : std::uint8_t {
  depth,    // the tip goes to a depth below the skin
  target,   // to the end of the path
  outside,  // far enough outside the skin for tented skin to release the shaft
  hold      // the needle rests
};
struct MotionStep {
  MotionGoal goal = MotionGoal::target;
  double depth = 0.0;           // mm below the skin, -10 to 500, of MotionGoal::depth
  std::optional<double> speed;  // mm/s, 0.5 to 500; that of the command if absent
  double time = 0.0;            // s, 0 to 600, of MotionGoal::hold
};
using NeedleMotion = std::vector<MotionStep>;

// A motion in words, steps separated by commas: "25 at 10, hold 2, 10 at 20, 45 at 5, hold 1, out". A step is a depth
// below the skin in mm, `target` or `out`, each optionally with a speed in mm/s, or `hold` with a time in s. Throws
// InputError naming `option`, the step and what was expected; also for a motion that never goes below the skin.
NeedleMotion parse_motion(std::string_view text, const std::string& option);

// The kind of a part of a motion. It is `reinsertion` as far as the tip has been before, and `insertion` from there
// on.
enum class MotionPhase : std::uint8_t { insertion, stop, withdrawal, reinsertion };
inline constexpr std::size_t motion_phases = 4;
inline constexpr std::array<std::string_view, motion_phases> phase_names = {"insertion", "stop", "withdrawal",
                                                                            "re-insertion"};

// A path as long as a motion goes deep: the end of the path if the motion has a step to the target, or else its
// deepest step, but never deeper than the hub allows. `beyond` as for straight_path. Throws what straight_path
// throws.
StraightPath path_of_motion(const anatomy::Case& patient, const std::optional<Vec3>& entry,
                            const std::optional<Vec3>& target, const NeedleMotion& motion, double beyond = 0.0);

// The end of a step, mm along the path; `from` for a hold.
double end_of_step(const MotionStep& step, const StraightPath& line, double from);

// s of a motion from the start of the path, going no deeper than `deepest` mm along the path.
double duration_of(const NeedleMotion& motion, const StraightPath& line, double speed, double deepest);

// A motion tick by tick.
struct MotionTicks {
  std::vector<double> places;      // mm along the path; the first is its start
  std::vector<MotionPhase> parts;  // kinds of the parts
  std::vector<std::size_t> first;  // tick of each part, then the number of ticks
};

// All positions of a motion, no deeper than `deepest`, at `speed` mm/s for steps without a speed, `dt` s apart.
MotionTicks ticks_of(const NeedleMotion& motion, const StraightPath& line, double speed, double dt, double deepest);

}  // namespace bodkin::study
