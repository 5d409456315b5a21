#pragma once

#include <vector>

#include "patient/from_ct/body_surface.h"
#include "patient/from_ct/tissue_lattice.h"

#include "anatomy/case.h"
#include "core/progress.h"

namespace bodkin::patient {

// Thickness of the skin of the waist, 1.91 mm (Laurent et al. 2007, reference/layer_thickness.csv), to the nearest
// half millimetre of the lattices on which it is drawn.
inline constexpr double skin_thickness = 2.0;

// Fills `lattice` with tissues: air outside the body; inside it the tissues of the labels, and of the HU where there
// are none. A label's tissue applies unless it is impossible: no bone in clear fat at a label's border, no muscle in
// cortical bone, nothing but gas in gas. Voxels of the structures "spinal_canal" are left to HU here. No skin yet.
// `structures` lies on the lattice of `ct` or is empty. Structures use tissues of Bodkin or of `library`; throws
// InputError for another tissue.
anatomy::TissueVolume classify_tissues(const anatomy::CtVolume& ct, const anatomy::LabelVolume& structures,
                                       const std::vector<anatomy::Structure>& table,
                                       const anatomy::TissueLibrary& library, const TissueLattice& lattice,
                                       const BodySurface& body, const Progress& progress);

// Turns the outermost `skin_thickness` of the body into skin where it meets air; not on faces where the image cuts
// the body.
void draw_skin(anatomy::TissueVolume& tissues);

// Dermis thicker than `skin_thickness` is as dense as muscle: such voxels between skin and subcutaneous fat, no
// deeper than 6 mm, also become skin. Muscle directly under the skin, without fat, stays muscle.
void thicken_skin(anatomy::TissueVolume& tissues, const BodySurface& body);

// True for tissues that stop a needle as bone does.
bool is_bone(anatomy::TissueId id);

}  // namespace bodkin::patient
