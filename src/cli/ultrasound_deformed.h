#pragma once

#include <string>
#include <vector>

#include "anatomy/case.h"
#include "cli/console.h"
#include "imaging/slice.h"
#include "imaging/ultrasound/ultrasound.h"

namespace bodkin::cli {

// The deformation of the tissue in a probe's image by a needle.
struct DeformedScan {
  imaging::NeedleInUltrasound needle;  // in the tissue
  Vec3 corner = Vec3::Zero();          // mm, the first point of the lattice of `moved`, probe's frame
  double spacing = 1.0;                // mm between them
  int columns = 0, rows = 0;
  std::vector<float> moved;  // mm, as ScanDisplacement has it
  double most = 0.0;         // mm, largest displacement in the image
  double force = 0.0;        // N, of the needle's resistance

  // Refers to `moved`.
  imaging::ScanDisplacement field() const { return {corner, spacing, columns, rows, moved}; }
};

// Inserts the needle of a case along its planned path, at 10 mm/s to `tip`, into the deformable body of the case's
// resistance (that of embedded_needle, if it has none), and returns the displacement of the tissue in the plane of a
// frame. `folder`: of the case. Throws InputError if the case has no mesh, and for the errors of prepare_body() and
// of an insertion.
DeformedScan deform_scan(anatomy::Case patient, const std::string& folder, const Vec3& tip,
                         const imaging::UltrasoundFrame& frame, const Pose& probe, Console& console);

}  // namespace bodkin::cli
