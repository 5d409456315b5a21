#pragma once

#include <string>
#include <vector>

#include "anatomy/volume.h"

namespace bodkin::io {

struct LabelPlacement {
  anatomy::LabelVolume labels;  // on the CT's grid; 0 where the segmentation does not reach
  std::vector<std::string> notes;
};

// Puts labels onto the lattice of their CT by where they lie in the patient. Labels on the same lattice, in any axis
// order and direction, whole or a part of it, are only re-indexed. Any other lattice is refused with an InputError
// that says by how much it is off (`name` is the file), unless `resample`: then each CT voxel takes the nearest
// label.
LabelPlacement place_labels(anatomy::LabelVolume&& labels, const anatomy::Grid& ct, bool resample,
                            const std::string& name);

}  // namespace bodkin::io
