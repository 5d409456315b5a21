#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "session/session_file.h"
#include "station/scan_thread.h"
#include "station/ultrasound_choice.h"

#include "anatomy/case.h"
#include "core/progress.h"
#include "imaging/ultrasound/ultrasound.h"

namespace bodkin::app {

// The ultrasound sample valid at `time` s, or the first one for earlier times; empty: the session has no machine.
std::optional<std::size_t> scan_at(const session::Session& session, double time);

// The border of the probe's field of view, LPS mm, a closed line; empty for a session without a machine.
std::vector<Vec3> scan_border(const session::Session& session, std::size_t sample);

// The ultrasound machine of a recorded session: recomputes its images from the recorded probe poses and machine
// settings. The tissue does not move, even if the session's body was deformable, nor do left needles.
class ScanReplay {
 public:
  // For a session with samples of a machine. Throws InputError if the patient allows no image.
  ScanReplay(const session::Session& session, const anatomy::Case& patient, const Progress& progress);

  // Probe and machine of a sample, for display.
  station::UltrasoundChoice choice(std::size_t sample) const;
  // The image of a sample with the needle at `needle`. Unchanged until the next call.
  const station::LiveImage& picture(std::size_t sample, const Pose& needle);

 private:
  std::vector<session::ScanSample> samples_;
  anatomy::Needle needle_;
  std::vector<imaging::NeedleInUltrasound> left_;
  imaging::Ultrasound machine_;
  station::LiveImage picture_;
  std::optional<std::size_t> shown_;  // of the image
};

}  // namespace bodkin::app
