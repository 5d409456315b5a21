#pragma once

#include <string>
#include <vector>

#include "tracking/marker_body.h"

namespace bodkin::tracking {

// A PDF (A4) to print at 100 %: the faces of every body to scale, those of a cube as one net with fold lines and glue
// tabs, and on each page a ruler of 100 mm for checking the print. Throws InputError naming a body that does not fit
// on a page.
std::string marker_sheets_pdf(const std::vector<MarkerBody>& bodies);

}  // namespace bodkin::tracking
