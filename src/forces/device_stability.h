#pragma once

#include <string>

#include "anatomy/case.h"

namespace bodkin::forces {

// Throws InputError unless `stiffness` (N/mm) is at most the device's: a spring that the device cannot render stably
// makes the hand oscillate. The message says which spring of `model` it is and how to correct it.
void require_stable(const std::string& model, const std::string& what, double stiffness,
                    const anatomy::DeviceLimits& device);

// As require_stable(), for a spring that acts across the needle or in every direction.
void require_stable_across(const std::string& model, const std::string& what, double stiffness,
                           const anatomy::DeviceLimits& device);

// As require_stable(), for a damping (N s/mm) that acts with a spring, by the bound of Colgate and Schenkel (1994): a
// device that renders a stiffness K stably has at least K T/2 of damping of its own.
void require_stable_damping(const std::string& model, double stiffness, double damping,
                            const anatomy::DeviceLimits& device, double dt);

}  // namespace bodkin::forces
