#pragma once

#include <string>

#include "station/ultrasound_choice.h"

namespace bodkin {

// What --ultrasound of `bodkin perform` says: "PROBE SETTING=VALUE ...". Throws InputError naming --ultrasound.
UltrasoundChoice choose_pane(const std::string& words);

}  // namespace bodkin
