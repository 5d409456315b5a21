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

// The sample of the session's ultrasound machine that held at `time` s, or its first one before that; nothing: there
// was no machine.
std::optional<std::size_t> scan_at(const session::Session& session, double time);

// The border of what the probe saw, LPS mm, a closed line; empty for a session without a machine.
std::vector<Vec3> scan_border(const session::Session& session, std::size_t sample);

// The ultrasound machine of a recorded session: its pictures, made again from how the probe was held and the machine
// was set. The tissue lies still, also where the session's body was a deformable one, and so do needles that were
// left.
class ScanReplay {
 public:
  // Of a session that has samples of a machine. Throws InputError when the patient gives no picture.
  ScanReplay(const session::Session& session, const anatomy::Case& patient, const Progress& progress);

  // Probe and machine as in a sample, for a view that shows them.
  station::UltrasoundChoice choice(std::size_t sample) const;
  // The picture of a sample with the needle at `needle`. Unchanged until the next call.
  const station::LivePicture& picture(std::size_t sample, const Pose& needle);

 private:
  std::vector<session::ScanSample> samples_;
  anatomy::Needle needle_;
  std::vector<imaging::NeedleInSound> left_;
  imaging::Ultrasound machine_;
  station::LivePicture picture_;
  std::optional<std::size_t> shown_;  // of the picture
};

}  // namespace bodkin::app
