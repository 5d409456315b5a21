#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "patient/planning/obstacles.h"
#include "patient/segmentation/label_editor.h"

#include "anatomy/case.h"
#include "core/progress.h"

namespace bodkin::patient {

// What a filter does to the mask of one structure.
struct SegmentFilter {
  enum class Kind : std::uint8_t {
    threshold,  // all voxels between low and high
    grow,       // those that hang together with the seed through voxel faces
    fill,       // slices between two that hold voxels take the shape between them
    smooth      // what is smaller than the radius goes
  };
  Kind kind = Kind::threshold;
  int low = 150, high = 3071;           // HU, both belong to it
  std::array<int, 3> seed = {0, 0, 0};  // voxel; of grow, and the middle of `reach`
  double reach = 0.0;                   // mm about the seed beyond which nothing is taken; 0: no limit
  int axis = 2;                         // of fill: the axis of the lattice across which the slices lie
  double radius = 1.0;                  // mm, of smooth
};

// Runs a filter in the image worker (a process of its own, which holds ITK). `mask` is the structure as it is; its
// lattice is that of the CT. Throws InputError (a seed outside of the image or of its own range, a range the wrong
// way round), SystemError when the worker is missing.
SegmentMask run_segment_filter(const anatomy::CtVolume& ct, const SegmentMask& mask, const SegmentFilter& filter,
                               const Progress& progress = {});

// What was saved with a case.
struct CorrectedCase {
  std::size_t changed_tissue_voxels = 0;  // of the tissue map
  std::vector<std::string> notes;         // sentences, also of the path
};

// Saves corrected labels with a case: structures, table, and what follows from them. Tissues are made anew from CT
// and labels as an import makes them; where that gives another tissue than the labels before did, the case takes it.
// A planned path that has become unsound, or comes too close to something by `rules`, gives way to the best one to
// its target. Runs in the image worker; the folder is replaced as a whole, so a failure leaves it as it was. A
// prepared mesh is left out, for it is of the tissues before. Structures without a voxel are dropped from the table.
// Throws InputError and SystemError.
CorrectedCase save_corrected_labels(const std::filesystem::path& folder, const anatomy::LabelVolume& labels,
                                    const std::vector<anatomy::Structure>& table, const PlanningRules& rules,
                                    const Progress& progress = {});

}  // namespace bodkin::patient
