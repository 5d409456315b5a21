#pragma once

#include "anatomy/case.h"
#include "anatomy/physical_tissue.h"

namespace bodkin::forces {

// The dependence of needle forces on diameter and tip, and the derivation of each force model's numbers from the
// physical description of a tissue. docs/needle-forces.md has derivations, sources and figures; each law is 1 at the
// reference needle of the tissue.
//
//   F_p = F_ref (d/d_ref)^n c/c_ref       n = 1: a cut of the needle's width (toughness times width, Shergold and
//                                         Fleck 2005); n = 2: a hole of its area, as flavum has it at 16 and 18 G
//   c = 0.77 s + 0.23 tan b / tan 20 deg  s: tearing, b: bevel. Shares 61 : 18 of Barnett et al. 2015 without
//                                         the friction of the shaft
//   k = F_ref/x_ref d/d_ref               stiffness before puncture, that of a punch; dimpling x = F_p/k
//   F_c = share F_p 0.77 s/c              cutting on inside the tissue: it tears as before, and is spread already
//   f = tau pi d                          N per mm of shaft: friction on its perimeter

// c, 1 for a quincke needle. A tip without an edge stretches its hole open, s = 1.22: taper-point needles need 1.08
// times the force of cutting ones in human skin (mean of three pairs, Maloney et al.). A trephine cuts a whole ring,
// s = pi.
double tip_factor(const anatomy::Needle& needle) noexcept;
// N, F_p: the puncture force of the tissue's boundary.
double puncture_force(const anatomy::PhysicalTissue& tissue, const anatomy::Needle& needle) noexcept;
// N, F_c: the cutting force inside the tissue.
double cutting_force(const anatomy::PhysicalTissue& tissue, const anatomy::Needle& needle) noexcept;
// N/mm, k; 0 for a boundary without a puncture force.
double boundary_stiffness(const anatomy::PhysicalTissue& tissue, const anatomy::Needle& needle) noexcept;
// N/mm, f, of the sliding shaft.
double friction_per_length(const anatomy::PhysicalTissue& tissue, const anatomy::Needle& needle) noexcept;

// Whether the library has the physical description of the tissue; if not, each model uses its own numbers.
bool is_described(const anatomy::PhysicalTissue& tissue) noexcept;

// The tissues as the models of a case feel them: those of its library, or with mechanics="physical" the numbers that
// each model derives from the physical description for the case's needle and device.
anatomy::TissueLibrary effective_tissues(const anatomy::Case& patient);

// Settings of models with only one membrane, which is then the skin: unchanged with mechanics="tables".
anatomy::DepthProfileSettings felt_settings(const anatomy::DepthProfileSettings& settings,
                                            const anatomy::Case& patient);
anatomy::ThreeComponentSettings felt_settings(const anatomy::ThreeComponentSettings& settings,
                                              const anatomy::Case& patient);
anatomy::FractureSettings felt_settings(const anatomy::FractureSettings& settings, const anatomy::Case& patient);

}  // namespace bodkin::forces
