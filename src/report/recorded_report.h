#pragma once

#include <filesystem>
#include <string>

#include "session/session_file.h"

#include "training/score.h"

namespace bodkin::report {

// Judges a session on the patient that it keeps; one of before format version 5, which keeps none, on `patient`, and
// where that has `changed` since, by what the session itself recorded.
training::Score score_for_report(const session::Session& session, const anatomy::Case& patient, bool changed,
                                 const training::Procedure& procedure, const training::ExpertSet* experts);

// The report of a session file on the case that it was recorded on, judged by the procedure that this case names: see
// report_html(). Throws InputError when the session or its case cannot be read.
std::string recorded_report_html(const std::filesystem::path& session);

}  // namespace bodkin::report
