#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "patient/planning/obstacles.h"

#include "anatomy/case.h"
#include "core/progress.h"

namespace bodkin::patient {

// A new segmentation for an existing case.
struct Relabelling {
  std::filesystem::path folder;           // of the case
  std::filesystem::path labels;           // an image on the lattice of its CT
  std::vector<anatomy::Structure> table;  // meaning of the labels
  PlanningRules rules;                    // obstacles and margins of a planned path
};

struct RelabelledCase {
  std::size_t changed_tissue_voxels = 0;
  std::vector<std::string> notes;  // changes of the path, and omissions
};

// Replaces the segmentation of a case, and everything derived from it. Tissues are computed from the CT with the old
// and with the new labels; where the two differ, the case gets the new tissue, so that a patient whose tissues were
// not derived from labels (a synthetic one) changes only where the labels did. The planned path stays if it is valid
// and keeps its previous margins; else it is replaced by the best one to its target or, if there is none, removed.
// Writes a whole new folder and replaces the old one in one step. Throws InputError and SystemError; the case is then
// unchanged.
RelabelledCase relabel_case(const Relabelling& wanted, const Progress& progress = {});

}  // namespace bodkin::patient
