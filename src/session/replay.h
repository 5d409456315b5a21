#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "session/session_file.h"

#include "core/progress.h"
#include "fem/solid/elastic_body.h"

namespace bodkin::session {

// The first difference between a recomputation and its recording.
struct ReplayDifference {
  std::uint64_t tick = 0;
  double time = 0.0;     // s
  std::string field;     // "applied_force_x", "tissue", "events", ...
  std::string recorded;  // as text that determines every bit
  std::string recomputed;
};

struct ReplayResult {
  std::uint64_t ticks = 0;                     // recomputed
  std::string digest;                          // of everything recomputed: XXH3, 16 hexadecimal digits
  std::optional<ReplayDifference> difference;  // empty: identical to the last bit
  // One sentence when the deformable body differs from the session's, though its case is the same; empty: it does
  // not, or the session has no record of it.
  std::string body_difference;
};

// Throws InputError for a session that lacks data needed for its recomputation: the corridor of nodes of the needle,
// in older versions, or the motion of the body under a probe.
void check_recomputable(const Session& session);

// Feeds the recorded needle poses to a new haptic tick on `patient`, with the force models of the session instead of
// the case's, and compares every number, flag and event with the recording, bit by bit (except, in sessions of format
// version 2, losses of resistance, which followed another rule). Stops at the first difference. `body`: the
// description of the patient's deformable body, for contact points off the planned line and for a moving body; may be
// null for a session without either. Throws InputError when the session cannot be replayed: it contains no ticks,
// ticks are missing, its tick does not match its force models, `body` is missing, or check_recomputable() throws.
ReplayResult replay_session(const Session& session, anatomy::Case patient, const Progress& progress = {},
                            const fem::BodyDescription* body = nullptr);

// Throws InputError unless `patient`, read from `case_folder`, is the patient of the session.
void check_same_case(const Session& session, const anatomy::Case& patient, const std::string& case_folder);

}  // namespace bodkin::session
