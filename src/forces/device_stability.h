#pragma once

#include <string>

#include "anatomy/case.h"

namespace bodkin::forces {

// A spring that the device cannot render stably makes the hand shake. Throws InputError that says which one of
// `model` it is and what would mend it, unless `stiffness` (N/mm) is at most the device's.
void require_stable(const std::string& model, const std::string& what, double stiffness,
                    const anatomy::DeviceLimits& device);

// The same of a spring that acts across the needle, or to every side.
void require_stable_across(const std::string& model, const std::string& what, double stiffness,
                           const anatomy::DeviceLimits& device);

// The same for a damping (N s/mm) beside a spring, by the bound of Colgate and Schenkel (1994): a device that renders
// a stiffness K stably has at least K T/2 of damping of its own.
void require_stable_damping(const std::string& model, double stiffness, double damping,
                            const anatomy::DeviceLimits& device, double dt);

}  // namespace bodkin::forces
