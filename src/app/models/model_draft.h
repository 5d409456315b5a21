#pragma once

#include <filesystem>

#include "app/models/parameter_model.h"

namespace bodkin::app {

// Differences from the patient's own force model are stored in the case folder as `models.draft.json` when the window
// closes or another patient is opened: the model's name, the changed tissues as a library, and each changed number.

// Writes no file without differences. Throws SystemError.
void keep_model_draft(ParameterModel& model, const std::filesystem::path& folder);
// Restores the stored draft as one step that can be undone. False, without a change, if there is none or it cannot be
// read; numbers that the model no longer has or allows are skipped.
bool take_model_draft(ParameterModel& model, const std::filesystem::path& folder);

}  // namespace bodkin::app
