#pragma once

#include <vector>

#include "anatomy/case.h"

namespace bodkin::fem {

// A point on a needle's line where it meets the body: at every border of tissues, and at equal distances behind it
// until the next border.
struct ContactSite {
  Vec3 place = Vec3::Zero();                        // mm, LPS, at rest
  double depth = 0.0;                               // mm behind the entry, along the line
  anatomy::TissueId tissue = anatomy::tissue::air;  // that the needle is in behind this point
  bool border = false;                              // another tissue, or none, lies before it
  bool resists = false;  // it has to be punctured: its puncture force is higher than that of the tissue before
};

// The sites of a needle along `path`, as deep as `length` mm behind its entry or as the first rigid tissue, in
// ascending order; `apart` mm, above 0, between those of one tissue. The voxels say which tissues the line crosses. A
// layer thinner than 0.3 mm along the line is ignored, and so is one between two pieces of one tissue that is thinner
// than three quarters of a voxel: a corner of the voxels' staircase, at which a layer would be felt twice. The same
// holds for a corner of the skin with air behind it.
std::vector<ContactSite> contact_sites_along(const anatomy::NeedlePath& path, double length, double apart,
                                             const anatomy::Case& patient);

// The sites ahead of a needle that has turned inside the body: from `place` (LPS, at rest) along the unit vector
// `along`, by the same rules. The needle is in the tissue `behind` there; a border is placed where another tissue
// begins; rigid tissue in the first 3 mm is skipped.
std::vector<ContactSite> contact_sites_ahead(const Vec3& place, const Vec3& along, double length, double apart,
                                             anatomy::TissueId behind, const anatomy::Case& patient);

}  // namespace bodkin::fem
