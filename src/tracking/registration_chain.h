#pragma once

#include "tracking/registration.h"

namespace bodkin::tracking {

// A registration (mannequin <- patient) followed by an earlier one (board <- mannequin): board <- patient. The
// residuals and FRE are those of the first. Errors are assumed independent; their covariances are added after those
// of the first were rotated and scaled. The degrees of freedom of the sum are Satterthwaite's (1946). The result has
// errors, and a prediction at the target of the first if it has one, only if both have errors.
Registration followed_by(const Registration& first, const Registration& second);

}  // namespace bodkin::tracking
