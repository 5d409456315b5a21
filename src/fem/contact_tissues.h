#pragma once

#include <array>

#include "anatomy/tissue.h"

namespace bodkin::fem {

// Contact properties of a tissue of a deformable body.
struct ContactTissue {
  double friction = 0.0;        // mu_t, N/mm: Coulomb force per mm of shaft; 0 to 10
  double puncture_force = 0.0;  // F_p, N along the needle, at which the tissue is punctured; 0 to 100, 0 = at once
  double cutting_force = 0.0;   // F_c, N along the needle, with which the tip cuts inside the tissue; 0 to 100
  double stiffness = 0.0;       // k_target, N/mm, only of `ClosestNodeContact`; 0 to 100, 0 = that of the mesh
};

using ContactTissues = std::array<ContactTissue, 256>;  // 256, by TissueId

// Sutherland et al. 2013 as read in docs/fem-contact.md: skin 1.5 N and ligamentum flavum 4.7 N are the paper's
// results [P], everything else our choice [D]: 0.9 N in soft tissue, in the middle of the paper's 0.5 to 1.5 N;
// friction 0.02 N/mm in soft tissue and 0.2 N/mm in ligaments. Gas and fluids exert no force; bone and metal hold 100
// N.
ContactTissues default_contact_tissues();

// Throws InputError naming tissue, quantity, value and range when a number is outside its range.
void check_contact_tissues(const ContactTissues& tissues);

}  // namespace bodkin::fem
