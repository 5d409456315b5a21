#pragma once

#include <string>
#include <vector>

#include "station/station_options.h"

#include "cli/console.h"
#include "cli/device_options.h"
#include "cli/force_options.h"
#include "cli/second_options.h"

namespace bodkin::cli {

// The command line of `bodkin perform`.
struct PerformOptions {
  std::string folder;
  DeviceOptions device;
  std::string output = "session-by-hand.bodkin";
  bool overwrite = false;
  double longest = 600.0;    // s
  double scale = 1.0;        // mm of the needle per mm of the hand
  double force_scale = 1.0;  // N at the hand per N of the needle
  std::string mannequin;     // registration of the device to a mannequin; "": none
  bool at_hub = false;
  bool no_calibration = false;
  bool allow_late = false;
  SecondOptions second;
  ForceOptions forces;
  std::string body;               // "": static
  std::string ultrasound;         // "": none
  std::vector<std::string> left;  // "ENTRY:TIP" of needles left in the body
};

// The examples and the keys, below --help.
extern const char* const perform_footer;

void add_perform_options(CLI::App& command, PerformOptions& options);

// Loads the drivers and the case, and parses every text. Throws InputError naming the option.
station::StationOptions station_options(const PerformOptions& options, Console& console);

// The mouse holds the needle, or ultrasound is requested: both require bodkin-app.
bool needs_window(const PerformOptions& options);
// The options for bodkin-app --attempt, as JSON. Checks all but the case; throws InputError naming the option.
std::string attempt_json(const PerformOptions& options);

}  // namespace bodkin::cli
