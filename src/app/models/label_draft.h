#pragma once

#include <optional>
#include <vector>

#include "views/open_case.h"

#include "anatomy/case.h"
#include "anatomy/volume.h"

namespace bodkin::app {

// Structures that were corrected and not saved, as they were when the window closed or another patient was opened.
struct LabelDraft {
  anatomy::LabelVolume labels;
  std::vector<anatomy::Structure> table;
};

// Two files in the patient's folder, `structures.draft.nrrd` and `.json`. Throws SystemError.
void keep_label_draft(const views::OpenCase& patient, const LabelDraft& draft);
// Nothing where none is kept, it cannot be read, or the patient has other structures than when it was made.
std::optional<LabelDraft> kept_label_draft(const views::OpenCase& patient);
void forget_label_draft(const views::OpenCase& patient) noexcept;

}  // namespace bodkin::app
