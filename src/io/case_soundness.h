#pragma once

#include <string>
#include <vector>

#include "anatomy/case.h"

namespace bodkin::io {

// Where the volumes of a case do not lie on each other as they must, one sentence each: the structures on the CT's
// lattice, the tissues over the CT's box. Volumes that are empty are passed over.
std::vector<std::string> lattice_problems(const anatomy::Case& patient);

// What is wrong with `path` as the planned path of this patient, one sentence each: it misses the image, the skin or
// its aim, goes into the spinal cord, or is longer than the needle. Empty = sound.
std::vector<std::string> path_problems(const anatomy::Case& patient, const anatomy::NeedlePath& path);

// Everything else that is wrong inside a case, one sentence each: labels and tissue ids that nothing explains, and a
// planned path that misses the image, the skin or its aim, goes into the spinal cord, or is longer than the needle.
// Empty = valid.
std::vector<std::string> content_problems(const anatomy::Case& patient);

}  // namespace bodkin::io
