#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/ultrasound_options.h"

namespace bodkin::cli {

// Throws InputError where no window can be opened.
void require_window();

// A window in which mouse and keyboard lead the probe, until it is closed. Returns the pictures that were saved,
// whose names begin with `base`. Throws InputError where there is no display, SystemError where SDL is not installed.
std::vector<std::string> scan_live(const anatomy::Case& patient, const station::UltrasoundChoice& choice,
                                   const imaging::ProbeOnSkin& hand,
                                   const std::optional<imaging::NeedleInSound>& needle, imaging::Ultrasound& machine,
                                   const std::string& base);

}  // namespace bodkin::cli
