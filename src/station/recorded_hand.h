#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "session/session_file.h"

#include "haptics/bodkin_driver.h"

namespace bodkin::station {

// The hand of a session, as a device would have reported it: the needle's poses taken back through the workspace in
// which its patient lay (workspace_about the session's path, scale 1).
struct RecordedHand {
  double rate = 1000.0;     // Hz of the recording
  std::vector<Pose> poses;  // operator's frame, one a tick; a tick that was lost repeats the one before
  std::optional<anatomy::DeviceLimits> limits;  // of the device that was held, where it was not the case's
};

// Throws InputError for what is no session, and for one without a tick.
RecordedHand read_recorded_hand(const std::filesystem::path& file);

// A session is a device, "recorded:FILE.bodkin": each exchange reports the next pose, whatever the force. The last
// one stays, and ends the session that is performed with it. It renders no force. There are no settings.
const bodkin_driver& recorded_driver() noexcept;

}  // namespace bodkin::station
