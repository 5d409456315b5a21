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
  std::string missing;  // what could not be looked for, and why; empty: nothing
};

// Reads a session and judges it by `procedure` (a name or a file; empty: the one that its case names), on the case in
// `folder` (empty: where it was recorded), against the experts that come with Bodkin. Throws InputError.
RecordedScore score_recording(const std::filesystem::path& file, const std::string& procedure = {},
                              const std::filesystem::path& folder = {}, const Progress& progress = {});

}  // namespace bodkin::training
