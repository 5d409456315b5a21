#pragma once

#include <string>
#include <vector>

#include "tracking/registration.h"

#include "imaging/canvas.h"

namespace bodkin::tracking {

// The fixed points (rings), the moving ones where the registration lays them (dots), what is left between them
// (arrows, magnified, the scale written) and the target with its predicted TRE, in mm of the fixed frame: from the
// front (x to the right, z up) and from the side (y to the right, z up), side by side and to one scale. `names`: of
// the pairs, from anywhere; those that are long are cut short. `fixed` and `moving` are the pairs that `registration`
// was made of.
imaging::Canvas registration_picture(const Registration& registration, const std::vector<Vec3>& fixed,
                                     const std::vector<Vec3>& moving, const std::vector<std::string>& names);

// By how much a picture `extent` wide magnifies errors of at most `largest` (the same unit, above 0): 1, 2 or 5 times
// a power of ten, so that they reach an eighth of the extent at most; from 1 to 1000.
double error_magnification(double extent, double largest);

}  // namespace bodkin::tracking
