#pragma once

#include <filesystem>
#include <string>

#include "session/session_file.h"

#include "training/score.h"

namespace bodkin::report {

// Scores a session on the patient stored in it; one older than format version 5, which stores none, on `patient` or,
// if that has `changed` since then, only from the recording.
training::Score score_for_report(const session::Session& session, const anatomy::Case& patient, bool changed,
                                 const training::Procedure& procedure, const training::ExpertSet* experts);

// The report of a session file on the case of the recording, scored by the procedure named in that case: see
// report_html(). Throws InputError when the session or its case cannot be read.
std::string recorded_report_html(const std::filesystem::path& session);

}  // namespace bodkin::report
