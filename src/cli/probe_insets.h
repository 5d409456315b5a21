#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "station/pressed_scan.h"

#include "anatomy/case.h"
#include "imaging/image_rgb.h"

namespace bodkin::cli {

// What a tracked probe sees, in one corner of a picture, and the CT in its plane in another.
class ProbeInsets {
 public:
  // `folder`: of the patient's case. `note` takes sentences for the user.
  ProbeInsets(const anatomy::Case& patient, const std::filesystem::path& folder,
              const std::function<void(const std::string&)>& note);

  // The probe, as a tool in the patient, presses him until `time` (s, of the next picture); nothing: it is lifted.
  // How his tissue has moved then; null: it rests.
  std::shared_ptr<const imaging::MovedTissue> press(const std::optional<Pose>& probe, double time);
  // Where the probe was pressed last; without one there is no picture. `needle`: as a tool in the patient.
  void draw(imaging::ImageRgb& picture, const std::optional<Pose>& needle);

 private:
  const anatomy::Case& patient_;
  station::PressedScan scan_;
  std::optional<double> last_;  // s, time of the picture before
  std::optional<Pose> held_;    // the machine's probe
};

}  // namespace bodkin::cli
