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

// A filter of the mask of one structure.
struct SegmentFilter {
  enum class Kind : std::uint8_t {
    threshold,  // all voxels between low and high
    grow,       // those connected to the seed through voxel faces
    fill,       // empty slices between two that contain voxels get an interpolated shape
    smooth      // objects smaller than the radius disappear
  };
  Kind kind = Kind::threshold;
  int low = 150, high = 3071;           // HU, both included
  std::array<int, 3> seed = {0, 0, 0};  // voxel; for grow, and the middle of `reach`
  double reach = 0.0;                   // mm about the seed, limit of the result; 0: no limit
  int axis = 2;                         // for fill: the axis of the lattice across which the slices lie
  double radius = 1.0;                  // mm, for smooth
};

// Runs a filter in the image worker (a separate process, which holds ITK). `mask` is the present structure; its
// lattice is that of the CT. Throws InputError (a seed outside of the image or of its own range, an inverted range),
// SystemError when the worker is missing.
SegmentMask run_segment_filter(const anatomy::CtVolume& ct, const SegmentMask& mask, const SegmentFilter& filter,
                               const Progress& progress = {});

// Result of saving labels with a case.
struct CorrectedCase {
  std::size_t changed_tissue_voxels = 0;  // of the tissue map
  std::vector<std::string> notes;         // sentences, also of the path
};

// Saves corrected labels with a case: structures, table, and everything derived from them. Tissues are recomputed
// from CT and labels as in an import; where that gives another tissue than with the previous labels, the case gets
// it. A planned path that has become invalid, or violates a margin of `rules`, is replaced by the best one to its
// target. Runs in the image worker; the folder is replaced atomically, so a failure does not change it. A prepared
// mesh is removed, because it belongs to the previous tissues. Structures without a voxel are dropped from the table.
// Throws InputError and SystemError.
CorrectedCase save_corrected_labels(const std::filesystem::path& folder, const anatomy::LabelVolume& labels,
                                    const std::vector<anatomy::Structure>& table, const PlanningRules& rules,
                                    const Progress& progress = {});

}  // namespace bodkin::patient
