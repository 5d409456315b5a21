#pragma once

#include <filesystem>
#include <optional>

#include "anatomy/case.h"
#include "imaging/ultrasound/ultrasound.h"
#include "imaging/ultrasound_screen/screen.h"

namespace bodkin::app {

// What is on the screen of an ultrasound machine with all that was measured, and the CT of the same plane next to it,
// as NAME-1.png, or the first number that no file has. Returns the file. Throws SystemError when it cannot be
// written.
std::filesystem::path save_scan_picture(const imaging::UltrasoundScreen& screen, imaging::MarkSide mark,
                                        const anatomy::Case& patient,
                                        const std::optional<imaging::NeedleInSound>& needle,
                                        const std::filesystem::path& name);

}  // namespace bodkin::app
