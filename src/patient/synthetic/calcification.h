#pragma once

#include "anatomy/tissue.h"

namespace bodkin::patient {

// Id and name of the tissue that a synthetic patient with calcified ligaments has besides Bodkin's own. Its case
// holds a tissue library with it.
inline constexpr anatomy::TissueId calcified_ligament = 32;
inline constexpr const char* calcified_ligament_name = "calcified_ligament";

// `library` and the calcified ligament: a ligament with twice the puncture force of the ligamentum flavum, as bright
// as cancellous bone in a CT. Its numbers are our choice; nobody has measured a needle in it. Throws InputError where
// the library uses the id or the name for something else, or lacks the interspinous ligament, whose other numbers it
// has.
anatomy::TissueLibrary with_calcified_ligament(const anatomy::TissueLibrary& library);

}  // namespace bodkin::patient
