#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/deformation_picture.h"
#include "study/needle_motion.h"

#include "anatomy/case.h"
#include "core/progress.h"
#include "simulation/tick_record.h"

namespace bodkin::study {

// How a machine that does not feel forces drives a needle into a patient: straight, at one speed or by a motion.
struct ProfileOptions {
  std::optional<Vec3> entry, target;  // LPS mm; the case's planned path if absent
  double speed = 10.0;                // mm/s, 0.5 to 500
  double beyond = 0.0;                // mm past the target, 0 to 200
  double pause = 0.0;                 // s at the deepest point, 0 to 60
  bool withdraw = false;              // pull the needle out again at the same speed
  // Instead of the last three, at most 600 s; steps without a speed use `speed`. May be empty.
  NeedleMotion motion;
};

// A finished insertion, tick by tick.
struct Profile {
  anatomy::NeedlePath path;
  ProfileOptions options;
  double surface = 0.0;                             // mm along the path; the skin
  double dt = 0.001;                                // s
  std::vector<simulation::TickRecord> ticks;        // in order; events are in them
  std::vector<forces::DiagnosticName> diagnostics;  // of the force models
  DeformedState strongest;  // state at the largest resistance of a deformable body; without forces for other models
  DeformedState last;
  std::optional<double> stopped_by_bone;  // mm; depth at which bone would need more than the device's peak force
  std::string outcome;                    // how far the needle came, one sentence
  std::vector<std::string> notes;         // assumptions, one sentence each
};

// Drives the needle of `patient` along a path, from 10 mm before the skin, through the same tick as for a hand. The
// insertion ends at the target or at the end of the motion, or in bone once its force exceeds what the device
// renders; a motion then continues with its next step. Throws InputError when the path is invalid, lies outside the
// volume or misses the body (saying by how much), or when an option is out of its range.
Profile insert_at_constant_speed(const anatomy::Case& patient, const ProfileOptions& options,
                                 const Progress& progress = {});

// The table of a profile, a row per tick: time_s, depth_mm, velocity_mm_s, resistance_N, the requested and the
// applied force as LPS components in N, the tissue at the tip, the HU of the CT there (trilinear; empty outside it),
// the labelled structure there (empty if there is none), then the diagnostics of the force models.
std::string profile_csv(const Profile& profile, const anatomy::Case& patient);

}  // namespace bodkin::study
