#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/crossings.h"
#include "session/session_file.h"

#include "anatomy/case.h"

namespace bodkin::report {

// A structure that the needle must not enter, and what happened to it.
struct CriticalEntry {
  std::string structure;
  double time = 0.0;         // s, of the first entry
  double depth = 0.0;        // mm along the needle's line, at the first entry
  double time_inside = 0.0;  // s
  int entries = 0;           // counted again after 1 mm of travel outside
};

// A tissue over the whole session, however often the tip came there.
struct TissueTotal {
  anatomy::TissueId tissue = anatomy::tissue::air;
  double from = 0.0, to = 0.0;  // mm, shallowest and deepest depth of the tip in it
  double time = 0.0;            // s
  double peak_force = 0.0;      // N, largest resistance with the tip in it
  double peak_depth = 0.0;      // mm
};

// How long one of the governor's limits held the force back.
struct LimitTime {
  std::uint8_t limit = 0;  // one flag of force_limit
  double time = 0.0;       // s
};

// Where the tip ended, relative to the planned target.
struct TargetError {
  double distance = 0.0;  // mm
  double axial = 0.0;     // mm along the planned path, positive = too deep
  double lateral = 0.0;   // mm across it
};

// Which place of the tip counts as its last: where the session ended, when that was in the body; or else the last
// rest in the body of half a second; or else the deepest point.
enum class FinalTip { end_of_session, last_rest, deepest_point };

// What a session came to. Lengths of the tip's travel and everything about deviation count samples inside the body
// only.
struct SessionSummary {
  double duration = 0.0;                 // s, from the first to the last tick
  double time_in_body = 0.0;             // s
  std::optional<double> time_to_target;  // s from the first contact until the tip came within the tolerance
  int insertions = 0;                    // contacts with the body after having left it
  int redirections = 0;           // retreats of more than 5 mm followed by an advance on an axis turned by over 3 deg
  double path_length = 0.0;       // mm travelled in the body, sampled at 100 Hz so that noise does not add up
  double deviation_rms = 0.0;     // mm, distance of the tip from the planned segment
  double deviation_max = 0.0;     // mm
  double angle_at_contact = 0.0;  // deg between the needle and the planned path
  double angle_at_end = 0.0;      // deg
  double deepest = 0.0;           // mm
  double peak_force = 0.0;        // N, resistance
  double peak_depth = 0.0;        // mm
  anatomy::TissueId peak_tissue = anatomy::tissue::air;
  double work = 0.0;              // N mm that the hand did against the applied force (sum of -F . dp)
  Vec3 final_tip = Vec3::Zero();  // LPS mm
  FinalTip final_tip_from = FinalTip::deepest_point;
  TargetError final_error;
  double closest_distance = 0.0;             // mm, ever
  double closest_time = 0.0;                 // s
  std::optional<double> target_tissue_time;  // s, first time that the tip was in the target tissue
  int bone_contacts = 0;
  int losses_of_resistance = 0;
  int interventions = 0;          // times that the governor began to limit the force
  double limited_time = 0.0;      // s under a limit
  std::vector<LimitTime> limits;  // the limits that acted; slew with its ramp counts as slew
  std::vector<CriticalEntry> critical;
  std::vector<TissueTotal> tissues;       // in the order of their first depth
  std::vector<TissueCrossing> crossings;  // of the deepest insertion
};

// Computes all of it; the definitions stand in docs/reports.md. The session needs at least one tick (InputError).
SessionSummary summarise(const session::Session& session, const anatomy::Case& patient);

// The outcome in a few sentences for the person who held the needle, the most important first.
struct Verdict {
  bool reached = false;  // the tip came within the tolerance, or into the target tissue
  std::string headline;
  std::vector<std::string> remarks;
};
Verdict judge(const SessionSummary& summary, const session::Session& session, const anatomy::Case& patient);

}  // namespace bodkin::report
