#pragma once

#include <vector>

#include "anatomy/case.h"
#include "fem/contact_numbers.h"

namespace bodkin::simulation {

// What a needle meets in the deformable body of a patient, by his settings and his library, as felt by the device of
// the case. Throws InputError for settings or tissues out of range, and for a resistance without a deformable body.
fem::ContactNumbers contact_numbers(const anatomy::Case& patient);
// The same of `closest_node` with these settings.
fem::ContactNumbers contact_numbers(const anatomy::Case& patient, const anatomy::ClosestNodeSettings& settings);

// What a tissue of a deformable body is to a needle, by TissueId.
fem::ContactTissues contact_tissues(const anatomy::Case& patient);

// Whether two settings of a patient with a deformable body differ in nothing but what a needle in it feels at once
// (fem::ContactNumbers): capture radius, time of a puncture, friction before sliding, and of the tissues friction,
// puncture force and stiffness. Body and contact points are prepared with all else.
bool differ_in_contact_alone(const anatomy::HapticSettings& a,
                             const std::vector<anatomy::TissueProperties>& tissues_a,
                             const anatomy::HapticSettings& b,
                             const std::vector<anatomy::TissueProperties>& tissues_b);

}  // namespace bodkin::simulation
