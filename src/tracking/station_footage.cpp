#include "tracking/station_footage.h"

#include "tracking/marker_search.h"
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::tracking {

namespace fs = std::filesystem;

bool has_calibration(const FootageFiles& files) {
  std::error_code code;
  return !files.camera.empty() || fs::exists(fs::path(files.source) / "camera.json", code);
}

OpenedFootage open_footage_files(const FootageFiles& files) {
  OpenedFootage opened;
  std::error_code code;
  const fs::path source = files.source;
  const bool folder = fs::is_directory(source, code);
  SourceOptions options;
  options.rate = files.rate;
  if (!files.camera.empty()) {
    opened.camera = read_camera(files.camera);
    options.width = opened.camera.width;
    options.height = opened.camera.height;
    options.locks = opened.camera.controls;
  }
  if (!fs::exists(source, code) || folder || !files.camera.empty())
    opened.source = open_source(files.source, options);
  if (files.camera.empty()) {
    if (!has_calibration(files)) {
      throw InputError(
          fmt::format("{}: its camera is not calibrated; calibrate it with 'bodkin camera calibrate' and "
                      "name the file with --camera",
                      files.source));
    }
    opened.camera = read_camera(source / "camera.json");
  }
  const fs::path in_folder = source / "bodies.json";
  opened.bodies = !files.bodies.empty()                   ? read_bodies(files.bodies)
                  : folder && fs::exists(in_folder, code) ? read_bodies(in_folder)
                                                          : station_bodies();
  return opened;
}

std::string why_nothing_was_found(const std::string& source, const GreyImage& picture) {
  return is_mirrored(picture)
             ? fmt::format("{}: the pictures are mirrored left to right; switch mirroring off in the camera", source)
             : fmt::format(
                   "{}: no marker of the dictionary 4x4_50 is in these pictures; print the markers with "
                   "'bodkin markers --pdf' and keep them in view",
                   source);
}

Pose tool_in_patient(const MarkerBody& body, const Pose& camera_from_body, const Pose& camera_from_mannequin,
                     const Similarity& mannequin_from_patient) {
  const Pose mannequin_from_body = camera_from_mannequin.inverse() * camera_from_body;
  const Similarity patient_from_mannequin = mannequin_from_patient.inverse();
  const Mat3 turn = patient_from_mannequin.turn * mannequin_from_body.linear();
  const Vec3 along = (turn * body.axis).normalized();
  Vec3 side = turn.col(0) - along * along.dot(turn.col(0));
  side = side.norm() > 1e-6 ? Vec3(side.normalized()) : Vec3(along.unitOrthogonal());
  Pose tool = Pose::Identity();
  tool.linear().col(0) = side;
  tool.linear().col(1) = along.cross(side);
  tool.linear().col(2) = along;
  tool.translation() = patient_from_mannequin * (mannequin_from_body * body.tip);
  return tool;
}

Similarity placed_along(const anatomy::NeedlePath& path, const Vec3& at) {
  const Vec3 into = path.direction();
  // The mannequin's z is the path, its y the feet's direction as far as the path permits.
  Vec3 down = -Vec3::UnitZ() - into * into.dot(-Vec3::UnitZ());
  if (down.norm() < 0.1) down = Vec3::UnitY() - into * into.y();
  down.normalize();
  Similarity made;
  made.turn.row(0) = down.cross(into).transpose();
  made.turn.row(1) = down.transpose();
  made.turn.row(2) = into.transpose();
  made.shift = at - made.turn * path.entry;
  return made;
}

}  // namespace bodkin::tracking
