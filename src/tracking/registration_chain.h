#pragma once

#include "tracking/registration.h"

namespace bodkin::tracking {

// A registration (mannequin <- patient) followed by an earlier one (board <- mannequin): board <- patient. The
// residuals and FRE stay those of the first. Errors are taken as independent; their covariances add after those of
// the first were turned and scaled. The degrees of freedom of the sum are Satterthwaite's (1946). There are errors,
// and a prediction at the target of the first where it has one, only if both tell their errors.
Registration followed_by(const Registration& first, const Registration& second);

}  // namespace bodkin::tracking
