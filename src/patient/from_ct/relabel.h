#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "patient/planning/obstacles.h"

#include "anatomy/case.h"
#include "core/progress.h"

namespace bodkin::patient {

// Another segmentation for a case that there is.
struct Relabelling {
  std::filesystem::path folder;           // of the case
  std::filesystem::path labels;           // an image on the lattice of its CT
  std::vector<anatomy::Structure> table;  // what the labels are
  PlanningRules rules;                    // what a planned path keeps away from
};

struct RelabelledCase {
  std::size_t changed_tissue_voxels = 0;
  std::vector<std::string> notes;  // what happened to the path, and what was left out
};

// Replaces the segmentation of a case, and what follows from it. Tissues are built from the CT with the labels before
// and with the new ones; where the two differ, the case takes the new tissue, so that a patient whose tissues were
// not made from labels (a synthetic one) changes where the labels did, and there alone. The planned path stays when
// it is sound and keeps the margins that it kept before; else the best one to its target takes its place, or, where
// there is none, no path. Writes a whole new folder and puts it in the place of the old one in one step. Throws
// InputError and SystemError; the case is then as it was.
RelabelledCase relabel_case(const Relabelling& wanted, const Progress& progress = {});

}  // namespace bodkin::patient
