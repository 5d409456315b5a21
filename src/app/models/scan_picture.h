#pragma once

#include <filesystem>
#include <optional>

#include "anatomy/case.h"
#include "imaging/ultrasound/ultrasound.h"
#include "imaging/ultrasound_screen/screen.h"

namespace bodkin::app {

// Saves the screen of an ultrasound machine with all measurements, and the CT of the same plane next to it, as
// NAME-1.png, or with the first unused number. Returns the file. Throws SystemError if it cannot be written.
std::filesystem::path save_scan_picture(const imaging::UltrasoundScreen& screen, imaging::OrientationMarkerSide mark,
                                        const anatomy::Case& patient,
                                        const std::optional<imaging::NeedleInUltrasound>& needle,
                                        const std::filesystem::path& name);

}  // namespace bodkin::app
