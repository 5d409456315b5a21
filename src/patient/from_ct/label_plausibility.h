#pragma once

#include <string>
#include <vector>

#include "anatomy/case.h"

namespace bodkin::patient {

// Checks the meaning of labels by the HU of their voxels. `labels` lies on the lattice of `ct`. Throws InputError
// when two thirds of the labelled skeleton, or of the labelled muscle, have values impossible for bone (above 100 HU)
// or muscle (-80 to 150 HU), naming another version of TotalSegmentator whose numbers fit; and when labels moved
// along an axis by up to 60 mm would have at least 8 % more of their bone on bone. Returns a sentence for each
// structure that contradicts its name: bone with a median below 50 HU, muscle or an organ outside -80 to 300 HU, lung
// above -250 HU, a vertebra of more than 200 mL.
std::vector<std::string> check_labels(const anatomy::CtVolume& ct, const anatomy::LabelVolume& labels,
                                      const std::vector<anatomy::Structure>& table);

}  // namespace bodkin::patient
