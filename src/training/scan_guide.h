#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "training/measured.h"
#include "training/probe_track.h"

namespace bodkin::training {

// What an ultrasound picture can be seen to have shown, from the session and the landmarks that it keeps of its case:
// the planned target ("target"), a landmark by its name, and the spinous process of a lumbar vertebra
// ("spinous_process_L4"), which lies between the interspaces above and below it, halfway between the places where the
// ways through these enter the skin and the canal behind them.

// The middle of the spinous process of "L4", LPS mm; nothing for a case without the landmarks of both interspaces.
struct SpinousProcess {
  Vec3 middle = Vec3::Zero();
  Vec3 into = Vec3::Zero();  // unit, from the skin to the canal
};
std::optional<SpinousProcess> spinous_process(const anatomy::CaseDescription& description, std::string_view vertebra);

// What is looked for: a point, and what the picture must be turned to.
struct Sought {
  Vec3 point = Vec3::Zero();        // LPS mm
  std::optional<Vec3> beam_along;   // unit
  std::optional<Vec3> slice_along;  // unit
};
// Nothing for a case without the landmarks for it.
std::optional<Sought> find_sought(const anatomy::CaseDescription& description, const anatomy::NeedlePath& path,
                                  std::string_view what);

// Whether the picture of that moment shows it. The target counts when the planned path lies within guide_deg of the
// slice, a spinous process when the beam is within that of the straight way from the skin to the canal: elsewhere the
// picture is no guide for a needle (the limits of TrainUS). `machine`: as is_in_picture() has it.
bool is_shown(const Sought& sought, const ProbeMoment& probe, const anatomy::UltrasoundProbe* machine,
              const Thresholds& limits);

// The first time, in s since the first tick, at which the picture showed `what`.
std::optional<double> first_shown(const Attempt& attempt, std::string_view what);

// Whether the picture can show it at all: the target always, else what the case has landmarks for.
bool can_be_shown(const anatomy::CaseDescription& description, std::string_view what);

// The last insertion as it was begun: what can be known of the aim before the needle goes in.
struct Aim {
  double miss = 0.0;      // mm between the needle's straight line and the planned target
  double off_line = 0.0;  // mm of the tip from the line of the planned path
  double angle = 0.0;     // deg between needle and planned path
  int bone_contacts = 0;  // met on this first way, before the needle was drawn back by over retreat_mm
};
std::optional<Aim> aim_of(const Attempt& attempt);

// A step of an insertion that ultrasound guides, and whether it was kept.
struct GuideStep {
  std::string name;
  bool kept = false;
};
// The seven steps of TrainUS's lumbar exercise: the spinous processes of L5, L4 and L3 and then the target were shown
// before the first insertion; the line of the needle at the skin goes through the target and meets no bone; the tip
// is less than guide_mm from the planned line there, and the needle less than guide_deg. The last four alone for a
// case without a lumbar spine. Empty without a probe or an insertion.
std::vector<GuideStep> guide_steps(const Attempt& attempt);

}  // namespace bodkin::training
