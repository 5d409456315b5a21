#pragma once

#include "station/ultrasound_request.h"

#include "cli/arguments.h"

namespace bodkin::cli {

// Probe, its position and the machine's knobs, from the command line.
struct UltrasoundOptions {
  station::UltrasoundRequest wanted;  // except the numbers below, which may be absent
  double press = 3.0, depth = 0.0, focus = 0.0, frequency = 0.0, needle_depth = 0.0;
  Argument press_given, depth_given, focus_given, frequency_given, size_given, needle_depth_given;
};

void add_ultrasound_options(CLI::App& command, UltrasoundOptions& options);

// All given options.
station::UltrasoundRequest request_of(const UltrasoundOptions& options);

}  // namespace bodkin::cli
