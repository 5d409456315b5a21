#pragma once

#include <string>

#include "anatomy/case.h"

namespace bodkin::patient {

// "GAUGE", "GAUGE,LENGTH" or "GAUGE,LENGTH,TIP", such as "18,90,tuohy"; the gauge may be written 18G; lengths in mm;
// a filiform needle is solid. Missing parts are those of the default needle, 90 mm and quincke. Throws InputError
// naming the invalid part.
anatomy::Needle parse_needle(const std::string& text);

// Shortens a path into the dural sac to end in the middle of the epidural space that it crosses; unchanged if it
// crosses none.
anatomy::NeedlePath ended_in_epidural_space(const anatomy::NeedlePath& path, const anatomy::TissueVolume& tissues);

}  // namespace bodkin::patient
