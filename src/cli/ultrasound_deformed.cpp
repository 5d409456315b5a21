#include "cli/ultrasound_deformed.h"

#include <algorithm>
#include <utility>

#include "patient/prepared_body.h"
#include "study/deformation_picture.h"
#include "study/profile.h"
#include <fmt/format.h>

#include "core/error.h"
#include "imaging/warped_slice.h"

namespace bodkin::cli {

namespace {

constexpr double grid_spacing = 1.0;  // mm

}  // namespace

DeformedScan deform_scan(anatomy::Case patient, const std::string& folder, const Vec3& tip,
                         const imaging::UltrasoundFrame& frame, const Pose& probe, Console& console) {
  anatomy::ResistanceSettings& resistance = patient.description.haptics.resistance;
  if (anatomy::body_of(resistance) == nullptr) resistance = anatomy::EmbeddedNeedleSettings{};
  const std::shared_ptr<const fem::BodyDescription> body =
      patient::prepare_body(patient, folder, patient.description.procedure.path, console.progress(),
                            [&console](const std::string& text) { console.note(text); });
  study::ProfileOptions options;
  options.target = tip;
  const study::Profile profile = study::insert_at_constant_speed(patient, options, console.progress());
  if (profile.stopped_by_bone) console.note(profile.outcome);

  imaging::SlicePlane plane;
  plane.corner = probe * frame.corner;
  plane.right = probe.linear().col(0);
  plane.down = probe.linear().col(1);
  plane.pixel = frame.pixel;
  plane.width = frame.width;
  plane.height = frame.height;
  const imaging::SlicePlane grid = imaging::warp_grid(plane, grid_spacing);
  const std::vector<float> at_rest =
      study::displacements_at(*body, profile.last.forces, imaging::points_of(grid), console.progress());

  DeformedScan scan;
  scan.needle = {profile.last.needle, patient.description.needle};
  scan.force = profile.last.resistance;
  scan.moved = imaging::displacements_of_places(grid, at_rest);
  for (std::size_t i = 0; i + 2 < scan.moved.size(); i += 3) {
    const Vec3 here(static_cast<double>(scan.moved[i]), static_cast<double>(scan.moved[i + 1]),
                    static_cast<double>(scan.moved[i + 2]));
    scan.most = std::max(scan.most, here.norm());
  }
  scan.corner = frame.corner;
  scan.spacing = grid.pixel;
  scan.columns = grid.width;
  scan.rows = grid.height;
  return scan;
}

}  // namespace bodkin::cli
