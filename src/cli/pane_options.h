#pragma once

#include <string>

#include "station/ultrasound_request.h"

namespace bodkin::cli {

// What --ultrasound of `bodkin perform` says: "PROBE SETTING=VALUE ...". Throws InputError naming --ultrasound.
station::UltrasoundRequest pane_request(const std::string& words);

}  // namespace bodkin::cli
