#include "app/models/scan_picture.h"

#include <vector>

#include <fmt/format.h>

#include "core/files.h"
#include "imaging/ultrasound_screen/scanner_image.h"

namespace bodkin::app {

std::filesystem::path save_scan_picture(const imaging::UltrasoundScreen& screen, imaging::OrientationMarkerSide mark,
                                        const anatomy::Case& patient,
                                        const std::optional<imaging::NeedleInUltrasound>& needle,
                                        const std::filesystem::path& name) {
  imaging::ScannerImage picture;
  picture.moment = screen.moment();
  picture.mark = mark;
  picture.patient = patient.description.name;
  picture.calipers = screen.calipers();
  picture.markers = screen.markers();
  std::vector<Vec3> line;
  if (needle) line = {patient.description.procedure.path->entry, needle->pose.translation()};
  picture.ct = imaging::ct_panel(patient, picture.moment, mark, line);
  std::filesystem::path file;
  for (int number = 1; file.empty() || std::filesystem::exists(file); ++number) {
    file = fmt::format("{}-{}.png", name.string(), number);
  }
  write_file(file, imaging::draw_scanner_image(picture, patient.library).png(1.0));
  return file;
}

}  // namespace bodkin::app
