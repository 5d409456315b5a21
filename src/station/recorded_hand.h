#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "session/session_file.h"

#include "haptics/bodkin_driver.h"

namespace bodkin::station {

// The hand of a session, as a device would have reported it: the needle's poses converted back through the session's
// workspace (workspace_about its path, scale 1).
struct RecordedHand {
  double rate = 1000.0;     // Hz of the recording
  std::vector<Pose> poses;  // operator's frame, one per tick; a lost tick repeats the previous one
  std::optional<anatomy::DeviceLimits> limits;  // of the device in use, if it was not the case's
};

// Throws InputError for an invalid session, and for one without a tick.
RecordedHand read_recorded_hand(const std::filesystem::path& file);

// A session as a device, "recorded:FILE.bodkin": each exchange reports the next pose, whatever the force. After the
// last one, which stays, the session performed with it ends. It renders no force. There are no settings.
const bodkin_driver& recorded_driver() noexcept;

}  // namespace bodkin::station
