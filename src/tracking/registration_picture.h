#pragma once

#include <string>
#include <vector>

#include "tracking/registration.h"

#include "imaging/canvas.h"

namespace bodkin::tracking {

// The fixed points (rings), the registered moving ones (dots), the residuals between them (arrows, magnified, with
// their scale) and the target with its predicted TRE, in mm of the fixed frame: from the front (x to the right, z up)
// and from the side (y to the right, z up), side by side and to one scale. `names`: of the pairs, unescaped; long
// ones are truncated. `fixed` and `moving` are the pairs of `registration`.
imaging::Canvas registration_picture(const Registration& registration, const std::vector<Vec3>& fixed,
                                     const std::vector<Vec3>& moving, const std::vector<std::string>& names);

// The magnification of errors of at most `largest` in an image `extent` wide (the same unit, above 0): 1, 2 or 5
// times a power of ten, so that they are at most an eighth of the extent; from 1 to 1000.
double error_magnification(double extent, double largest);

}  // namespace bodkin::tracking
