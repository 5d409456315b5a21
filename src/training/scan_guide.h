#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "training/measured.h"
#include "training/probe_track.h"

namespace bodkin::training {

// Visibility of targets in an ultrasound image, from the session and the landmarks of its case: the planned target
// ("target"), a landmark by its name, and the spinous process of a lumbar vertebra ("spinous_process_L4"), which lies
// between the interspaces above and below it, halfway between the points where the paths through these enter the skin
// and the canal behind them.

// The middle of the spinous process of "L4", LPS mm; empty for a case without the landmarks of both interspaces.
struct SpinousProcess {
  Vec3 middle = Vec3::Zero();
  Vec3 into = Vec3::Zero();  // unit, from the skin to the canal
};
std::optional<SpinousProcess> spinous_process(const anatomy::CaseDescription& description, std::string_view vertebra);

// A target to be shown: a point, and the direction that the image must have.
struct ScanTarget {
  Vec3 point = Vec3::Zero();        // LPS mm
  std::optional<Vec3> beam_along;   // unit
  std::optional<Vec3> slice_along;  // unit
};
// Empty for a case without its landmarks.
std::optional<ScanTarget> find_scan_target(const anatomy::CaseDescription& description,
                                           const anatomy::NeedlePath& path, std::string_view what);

// Whether the image at that time shows it. The target counts when the planned path lies within guide_deg of the
// slice, a spinous process when the beam is within that angle of the straight line from the skin to the canal:
// otherwise the image does not guide a needle (the limits of TrainUS). `machine`: as for is_in_picture().
bool is_shown(const ScanTarget& target, const ProbeState& probe, const anatomy::UltrasoundProbe* machine,
              const Thresholds& limits);

// The first time, in s since the first tick, at which the image showed `what`.
std::optional<double> first_shown(const Attempt& attempt, std::string_view what);

// Whether the image can show it at all: the target always, others if the case has landmarks for them.
bool can_be_shown(const anatomy::CaseDescription& description, std::string_view what);

// The initial aim of the last insertion, before the needle enters.
struct Aim {
  double miss = 0.0;      // mm between the needle's straight line and the planned target
  double off_line = 0.0;  // mm of the tip from the line of the planned path
  double angle = 0.0;     // deg between needle and planned path
  int bone_contacts = 0;  // during this first advance, before the needle was withdrawn by over retreat_mm
};
std::optional<Aim> aim_of(const Attempt& attempt);

// A step of an ultrasound-guided insertion, and whether it was fulfilled.
struct GuideStep {
  std::string name;
  bool kept = false;
};
// The seven steps of TrainUS's lumbar exercise: the spinous processes of L5, L4 and L3 and then the target were shown
// before the first insertion; the line of the needle at the skin passes through the target and meets no bone; the tip
// is less than guide_mm from the planned line there, and the needle less than guide_deg. Only the last four for a
// case without a lumbar spine. Empty without a probe or an insertion.
std::vector<GuideStep> guide_steps(const Attempt& attempt);

}  // namespace bodkin::training
