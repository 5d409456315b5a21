#pragma once

#include <filesystem>

#include "app/models/parameter_model.h"

namespace bodkin::app {

// What differs from the patient's own force model when the window closes or another patient is opened is kept in his
// folder, as `models.draft.json`: the model's name, the tissues that differ, as a library, and each number that was
// changed.

// No file where nothing differs. Throws SystemError.
void keep_model_draft(ParameterModel& model, const std::filesystem::path& folder);
// Takes over what is kept, as one step that can be undone. False, and nothing changed, where there is none or it
// cannot be read; a number that the model no longer has or allows is left out.
bool take_model_draft(ParameterModel& model, const std::filesystem::path& folder);

}  // namespace bodkin::app
