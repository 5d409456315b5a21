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

// A session whose needle is the real one that the page of augmented reality tracks, and whose ultrasound is that of
// the tracked probe: recorded and judged as every other. All calls from the window's thread; none waits but the last.
class TrackedAttempt {
 public:
  // The needle is that of these pictures, which must be tracked already (CameraWatch). `registration`: see there.
  // `ultrasound`: of the probe; nothing: without. Throws InputError for a patient without a planned path, SystemError
  // where no session can be kept.
  TrackedAttempt(const std::shared_ptr<const OpenCase>& patient, const tracking::FootageFiles& files,
                 const std::filesystem::path& registration,
                 const std::optional<station::UltrasoundChoice>& ultrasound);

  // Where the tracked probe is held now.
  void set_scan_order(const station::ScanOrder& order) { link_.set_scan_order(order); }
  void end() { link_.end(); }
  // Once a frame: what is new. A session of footage ends with it.
  const StationNews& poll();
  // How the needle has moved the tissue of a body that deforms, of the newest news; null: it rests.
  const std::shared_ptr<const imaging::MovedTissue>& moved_tissue() const { return moved_; }
  // What the person should read of the newest news, one sentence in the words of the source.
  static std::string sentence(const StationNews& news);
  static bool is_over(const StationNews& news);

 private:
  SliceTissue tissue_;
  std::shared_ptr<const imaging::MovedTissue> moved_;
  StationLink link_;
};

}  // namespace bodkin::app
