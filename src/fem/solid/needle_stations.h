#pragma once

#include <vector>

#include "anatomy/case.h"

namespace bodkin::fem {

// A place on a needle's line where it meets the body: at every border of tissues, and at equal distances behind it
// until the next.
struct NeedleStation {
  Vec3 place = Vec3::Zero();                        // mm, LPS, at rest
  double depth = 0.0;                               // mm behind the entry, along the line
  anatomy::TissueId tissue = anatomy::tissue::air;  // that the needle is in behind the place
  bool border = false;                              // another tissue, or none, lies before it
  bool resists = false;                             // it has to be punctured: it takes more force than the one before
};

// The stations of a needle along `path`, as deep as `length` mm behind its entry or as the first rigid tissue, in
// ascending order; `apart` mm, above 0, between those of one tissue. The voxels say which tissues the line crosses.
// What is thinner along it than 0.3 mm is none, and neither is what lies between two pieces of one tissue and is
// thinner than three quarters of a voxel: a corner of the voxels' staircase, at which a layer would be felt twice.
// The same holds for a corner of the skin that has air behind it.
std::vector<NeedleStation> stations_along(const anatomy::NeedlePath& path, double length, double apart,
                                          const anatomy::Case& patient);

// The stations ahead of a needle that has turned inside the body: from `place` (LPS, at rest) along the unit vector
// `along`, by the same rules. The needle is in the tissue `behind` there, and a border stands where another begins;
// rigid tissue in the first 3 mm is passed by.
std::vector<NeedleStation> stations_ahead(const Vec3& place, const Vec3& along, double length, double apart,
                                          anatomy::TissueId behind, const anatomy::Case& patient);

}  // namespace bodkin::fem
