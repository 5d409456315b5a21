#pragma once

#include <array>

#include "desktop/sdl_screen.h"
#include "station/live_scan.h"

#include "imaging/ultrasound_screen/screen.h"

namespace bodkin::desktop {

// The screen of an ultrasound machine with its letters, at its place of the window.
void draw_machine(SdlScreen& screen, const station::LiveScan::Place& place, const imaging::UltrasoundScreen& machine);

// The sliders of the time-gain compensation at their place of the window, each with the depth that it is of and its
// value, beside it. `depth`: mm shown.
void draw_sliders(SdlScreen& screen, const station::LiveScan::Place& place, const std::array<double, 8>& sliders,
                  double depth);

}  // namespace bodkin::desktop
