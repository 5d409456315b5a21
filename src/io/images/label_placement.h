#pragma once

#include <string>
#include <vector>

#include "anatomy/volume.h"

namespace bodkin::io {

struct LabelPlacement {
  anatomy::LabelVolume labels;  // on the CT's grid; 0 outside the segmentation
  std::vector<std::string> notes;
};

// Places labels onto the lattice of their CT by their position in the patient. Labels on the same lattice, in any
// axis order and direction, whole or a part of it, are only re-indexed. Any other lattice is rejected with an
// InputError that says by how much it is off (`name` is the file), unless `resample`: then each CT voxel gets the
// nearest label.
LabelPlacement place_labels(anatomy::LabelVolume&& labels, const anatomy::Grid& ct, bool resample,
                            const std::string& name);

}  // namespace bodkin::io
