#pragma once

#include <string>

#include "session/session_file.h"

#include "training/score.h"

namespace bodkin::training {

// Scores a session just recorded on `patient`: by the procedure named in the case, with all its voxels, and compared
// with the experts (experts_of). `procedure`: a name or a file instead; empty: the case's. Throws InputError.
Score score_on_case(const session::Session& session, const anatomy::Case& patient, const std::string& procedure = {});

}  // namespace bodkin::training
