#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tracking/station_footage.h"

#include "anatomy/needle_path.h"
#include "haptics/bodkin_driver.h"

namespace bodkin::tracking {

// A real tool with a marker body over a mannequin is the hand, "tracked:SOURCE": a camera, a video or a folder of
// pictures. It renders no force. Where it is not seen well it rests at the last place, and says so by
// BODKIN_BUTTON_UNSEEN. Two tools of one source share its pictures. docs/devices.md lists the settings.
const bodkin_driver& tool_driver() noexcept;

// Under what the sightings of these pictures are announced, for the driver to share them. `path`: of the patient;
// used where there is no registration.
std::string sightings_key(const FootageFiles& files, const std::filesystem::path& registration,
                          const std::optional<anatomy::NeedlePath>& path);

}  // namespace bodkin::tracking
