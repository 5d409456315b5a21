#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/models/slice_tissue.h"
#include "app/models/station_link.h"
#include "tracking/station_footage.h"
#include "views/open_case.h"

namespace bodkin::app {

using namespace views;

// A session with the real needle tracked by the augmented-reality page, and ultrasound of the tracked probe: recorded
// and judged like every other session. All calls from the window's thread; only the last one waits.
class TrackedAttempt {
 public:
  // The needle of these images, which must be tracked already (CameraWatch). `registration`: see there. `ultrasound`:
  // of the probe; empty: without. Throws InputError for a patient without a planned path, SystemError if no session
  // can be stored.
  TrackedAttempt(const std::shared_ptr<const OpenCase>& patient, const tracking::FootageFiles& files,
                 const std::filesystem::path& registration,
                 const std::optional<station::UltrasoundChoice>& ultrasound);

  // The present pose of the tracked probe.
  void set_scan_setup(const station::ScanSetup& setup) { link_.set_scan_setup(setup); }
  void end() { link_.end(); }
  // Once a frame: the news. A session of footage ends with it.
  const StationUpdate& poll();
  // The displacement of a deformable body's tissue by the needle, from the newest news; null: at rest.
  const std::shared_ptr<const imaging::TissueDisplacement>& moved_tissue() const { return moved_; }
  // The message of the newest news, one sentence in the source's language.
  static std::string sentence(const StationUpdate& news);
  static bool is_over(const StationUpdate& news);

 private:
  SliceTissue tissue_;
  std::shared_ptr<const imaging::TissueDisplacement> moved_;
  StationLink link_;
};

}  // namespace bodkin::app
