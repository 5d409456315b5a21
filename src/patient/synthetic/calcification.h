#pragma once

#include "anatomy/tissue.h"

namespace bodkin::patient {

// Id and name of the tissue that a synthetic patient with calcified ligaments has in addition to Bodkin's own. Its
// case contains a tissue library with it.
inline constexpr anatomy::TissueId calcified_ligament = 32;
inline constexpr const char* calcified_ligament_name = "calcified_ligament";

// `library` with the calcified ligament: a ligament with twice the puncture force of the ligamentum flavum, as bright
// as cancellous bone in a CT. Its numbers are our choice; needle forces in it have never been measured. Throws
// InputError if the library uses the id or the name for something else, or lacks the interspinous ligament, from
// which its other numbers are copied.
anatomy::TissueLibrary with_calcified_ligament(const anatomy::TissueLibrary& library);

}  // namespace bodkin::patient
