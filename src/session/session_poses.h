#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "session/session_file.h"

#include "core/progress.h"
#include "io/pose_log.h"

namespace bodkin::session {

// The poses of a session in the format of trackers, `rate` of them per second (at most one per tick):
// NeedleTipToReference, third axis hub to tip, and ProbeToReference of a second hand with a probe or else of an
// ultrasound machine, first axis towards its orientation marker, second into the depth. Reference is the patient in
// RAS mm. Events become messages, "contact (skin)". Throws InputError for a rate that is not 1 to 4000, and for a
// session without a tick.
io::PoseLog poses_of(const Session& session, double rate);

struct PoseImport {
  std::string needle = "NeedleTipToReference";  // see io::track_between
  std::string probe = "ProbeToReference";       // if there is one
  Mat3 tool = Mat3::Identity();                 // Bodkin's needle, third axis hub to tip, in the tracked tool
  std::filesystem::path output;                 // the session file
  bool overwrite = false;
};

struct PoseImportResult {
  std::uint64_t ticks = 0;
  std::uint64_t poses = 0;    // of the needle, in the file
  std::uint64_t samples = 0;  // of the probe
  double longest_gap = 0.0;   // s between two poses of the needle
};

// Moves a recorded needle through the patient: at each tick it has the recorded pose (PoseTrack::at), and the tick
// computes tissue, force and events there. The result is a session like one performed by a hand, with the same
// metrics. `header`: of the case; the operator is added. Throws InputError when the log has no such needle, fewer
// than two poses of it, more than an hour of them, or one that is farther than 2 m from the path's entry.
PoseImportResult import_poses(const anatomy::Case& patient, SessionHeader header, const io::PoseLog& log,
                              const PoseImport& how, const Progress& progress);

}  // namespace bodkin::session
