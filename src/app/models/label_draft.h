#pragma once

#include <optional>
#include <vector>

#include "views/open_case.h"

#include "anatomy/case.h"
#include "anatomy/volume.h"

namespace bodkin::app {

// Unsaved changes of structures, from when the window closed or another patient was opened.
struct LabelDraft {
  anatomy::LabelVolume labels;
  std::vector<anatomy::Structure> table;
};

// Two files in the patient's folder, `structures.draft.nrrd` and `.json`. Throws SystemError.
void keep_label_draft(const views::OpenCase& patient, const LabelDraft& draft);
// Empty if none is stored, if it cannot be read, or if the patient's structures have changed since then.
std::optional<LabelDraft> kept_label_draft(const views::OpenCase& patient);
void forget_label_draft(const views::OpenCase& patient) noexcept;

}  // namespace bodkin::app
