#pragma once

#include <string>

#include "station/ultrasound_choice.h"

namespace bodkin::cli {

// What --ultrasound of `bodkin perform` says: "PROBE SETTING=VALUE ...". Throws InputError naming --ultrasound.
station::UltrasoundChoice choose_pane(const std::string& words);

}  // namespace bodkin::cli
