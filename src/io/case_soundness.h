#pragma once

#include <string>
#include <vector>

#include "anatomy/case.h"

namespace bodkin::io {

// Mismatches between the lattices of a case's volumes, one sentence each: the structures must lie on the CT's
// lattice, the tissues cover the CT's box. Empty volumes are ignored.
std::vector<std::string> lattice_problems(const anatomy::Case& patient);

// Errors of `path` as the planned path of this patient, one sentence each: it misses the image, the skin or its
// target, enters the spinal cord, or is longer than the needle. Empty = valid.
std::vector<std::string> path_problems(const anatomy::Case& patient, const anatomy::NeedlePath& path);

// All other errors inside a case, one sentence each: unknown labels and tissue ids, and a planned path that misses
// the image, the skin or its target, enters the spinal cord, or is longer than the needle. Empty = valid.
std::vector<std::string> content_problems(const anatomy::Case& patient);

}  // namespace bodkin::io
