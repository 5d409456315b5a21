#pragma once

#include <filesystem>
#include <string>

#include "patient/acupuncture/atlas.h"

#include "anatomy/case.h"

namespace bodkin::patient {

// A case of a synthetic body: the whole body, or a block about a point with the needle's path planned.
struct BodyCase {
  std::filesystem::path folder;
  bool overwrite = false;
  std::string name;        // empty: the folder's
  std::string point;       // code or name of a point; empty: the whole body, without a path
  double width = 200.0;    // mm, of the block
  double spacing = 0.0;    // mm; 0: 4 of the whole body, 1 of a block
  std::uint64_t seed = 1;  // of the noise of the HU
};

// Writes it with the procedure "acupuncture" and a filiform needle of 0.23 mm, long enough for the point. Atomic.
// Throws InputError for an unknown point, sizes out of range, and a folder that may not be replaced; SystemError for
// a disk error.
anatomy::CaseDescription write_body_case(const Atlas& atlas, const BodyCase& wanted, const Progress& progress = {});

}  // namespace bodkin::patient
