#pragma once

#include <string>
#include <vector>

#include "anatomy/case.h"
#include "io/images/dicom_labels.h"

namespace bodkin::patient {

struct NamedStructures {
  std::vector<anatomy::Structure> table;
  std::vector<std::string> notes;  // one sentence each
};

// The meaning of labels with names in their file: a segmentation or structure set from a radiology system. A name
// used by TotalSegmentator, in any case, with any signs between its words and its words in any order ("Left Kidney"),
// is taken as such; tumours, lesions and target volumes are masses; other names are kept, and their voxels classified
// by HU, with a note.
NamedStructures structures_named(const std::vector<io::LabelName>& names);

}  // namespace bodkin::patient
