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

// The image of a tracked probe in one corner of an image, and the CT in its plane in another.
class ProbeInsets {
 public:
  // `folder`: of the patient's case. `note` receives messages for the user.
  ProbeInsets(const anatomy::Case& patient, const std::filesystem::path& folder,
              const std::function<void(const std::string&)>& note);

  // Presses the probe, as a tool in the patient, until `time` (s, of the next image); empty: it is lifted. Returns
  // the displacement of the tissue at that time; null: at rest.
  std::shared_ptr<const imaging::TissueDisplacement> press(const std::optional<Pose>& probe, double time);
  // At the last pressed pose; without one there is no image. `needle`: as a tool in the patient.
  void draw(imaging::ImageRgb& picture, const std::optional<Pose>& needle);

 private:
  const anatomy::Case& patient_;
  station::PressedScan scan_;
  std::optional<double> last_;  // s, time of the previous image
  std::optional<Pose> held_;    // the machine's probe
};

}  // namespace bodkin::cli
