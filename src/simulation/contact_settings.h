#pragma once

#include <vector>

#include "anatomy/case.h"
#include "fem/contact_numbers.h"

namespace bodkin::simulation {

// Contact properties of a patient's deformable body, from the patient's settings and library, as felt through the
// device of the case. Throws InputError for settings or tissues out of range, and for a resistance without a
// deformable body.
fem::ContactNumbers contact_numbers(const anatomy::Case& patient);
// As above, for `closest_node` with these settings.
fem::ContactNumbers contact_numbers(const anatomy::Case& patient, const anatomy::ClosestNodeSettings& settings);

// Contact properties of the tissues of a deformable body, by TissueId.
fem::ContactTissues contact_tissues(const anatomy::Case& patient);

// Whether two settings of a patient with a deformable body differ only in numbers that may change under a needle
// (fem::ContactNumbers): capture radius, time of a puncture, friction before sliding, and the tissues' friction,
// puncture force and stiffness. Body and contact points depend on all others.
bool differ_in_contact_alone(const anatomy::HapticSettings& a,
                             const std::vector<anatomy::TissueProperties>& tissues_a,
                             const anatomy::HapticSettings& b,
                             const std::vector<anatomy::TissueProperties>& tissues_b);

}  // namespace bodkin::simulation
