#pragma once

#include <filesystem>
#include <string>

#include "session/session_file.h"

#include "core/progress.h"
#include "training/score.h"

namespace bodkin::training {

// A session file with its score.
struct RecordedScore {
  session::Session session;
  anatomy::CaseDescription description;
  Score score;
  std::string missing;  // what could not be checked, and why; empty: nothing
};

// Reads a session that can be scored. Throws InputError as read_session() does, and for one without a tick.
session::Session read_attempt(const std::filesystem::path& file);

// Reads a session and scores it by `procedure` (a name or a file; empty: the one named in its case), on the stored
// patient or the case in `folder`, against the experts that come with Bodkin. Throws InputError, also if `folder` was
// given and is not the case of the session.
RecordedScore score_recording(const std::filesystem::path& file, const std::string& procedure = {},
                              const std::filesystem::path& folder = {}, const Progress& progress = {});

}  // namespace bodkin::training
