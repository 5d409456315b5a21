#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "session/session_file.h"

#include "core/progress.h"
#include "fem/solid/elastic_body.h"

namespace bodkin::session {

// The first place where a recomputation differs from the recording.
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
  std::optional<ReplayDifference> difference;  // nothing: identical to the last bit
  // One sentence when the deformable body came out otherwise than in the session, though its case is the same; empty:
  // the same, or the session does not say.
  std::string body_difference;
};

// Throws InputError for a session that lacks what its recomputation needs: in which corridor of nodes the needle was,
// as older versions prepared them, or how the body moved that a probe pressed.
void check_recomputable(const Session& session);

// Feeds the recorded needle poses to a new haptic tick on `patient`, with the force models that the session used
// instead of the case's, and compares every number, flag and event with the recording, bit by bit (of sessions of
// format version 2 not the losses of resistance, which followed another rule). Stops at the first
// difference. `body`: what the patient's deformable body was made of, for contact points beside the planned line and
// for a body that moved by itself; may be null for a session without either. Throws InputError when the session
// cannot be replayed: it holds no ticks, ticks are missing, its tick is not that of its force models, `body` is
// missing, or check_recomputable() refuses it.
ReplayResult replay_session(const Session& session, anatomy::Case patient, const Progress& progress = {},
                            const fem::BodyDescription* body = nullptr);

// Throws InputError unless `patient`, read from `case_folder`, is the one that the session was recorded on.
void check_same_case(const Session& session, const anatomy::Case& patient, const std::string& case_folder);

}  // namespace bodkin::session
