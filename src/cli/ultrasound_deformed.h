#pragma once

#include <string>
#include <vector>

#include "anatomy/case.h"
#include "cli/console.h"
#include "imaging/slice.h"
#include "imaging/ultrasound/ultrasound.h"

namespace bodkin::cli {

// What a needle has done to the tissue that a probe sees.
struct DeformedScan {
  imaging::NeedleInSound needle;  // in the tissue
  Vec3 corner = Vec3::Zero();     // mm, the first of the points at which `moved` is known, probe's frame
  double spacing = 1.0;           // mm between them
  int columns = 0, rows = 0;
  std::vector<float> moved;  // mm, as ScanDisplacement has it
  double most = 0.0;         // mm, the farthest that anything in the picture has moved
  double force = 0.0;        // N, of the needle's resistance

  // Looks at `moved`.
  imaging::ScanDisplacement field() const { return {corner, spacing, columns, rows, moved}; }
};

// Inserts the needle of a case along its planned path, at 10 mm/s to `tip`, into the deformable body of the case's
// resistance (that of embedded_needle, where it has none), and takes the displacement of the tissue in the plane of a
// frame. `folder`: of the case. Throws InputError when the case has no mesh, and for all that prepare_body() and an
// insertion refuse.
DeformedScan deform_scan(anatomy::Case patient, const std::string& folder, const Vec3& tip,
                         const imaging::UltrasoundFrame& frame, const Pose& probe, Console& console);

}  // namespace bodkin::cli
