#pragma once

#include <string>

#include "anatomy/case.h"

namespace bodkin::patient {

// "GAUGE", "GAUGE,LENGTH" or "GAUGE,LENGTH,TIP", such as "18,90,tuohy"; the
// gauge may be written 18G; lengths in mm; a
// filiform needle is solid. What is left out is that
// of the default needle, 90 mm and quincke. Throws InputError naming the part that is wrong.
anatomy::Needle parse_needle(const std::string& text);

// A path into the dural sac, ended in the middle of the epidural space that it crosses; unchanged when it crosses
// none.
anatomy::NeedlePath ended_in_epidural_space(const anatomy::NeedlePath& path, const anatomy::TissueVolume& tissues);

}  // namespace bodkin::patient
