#pragma once

#include <string>

#include "station/ultrasound_request.h"

namespace bodkin::cli {

// The value of --ultrasound of `bodkin perform`: "PROBE SETTING=VALUE ...". Throws InputError naming --ultrasound.
station::UltrasoundRequest pane_request(const std::string& words);

}  // namespace bodkin::cli
