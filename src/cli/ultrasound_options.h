#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "station/ultrasound_choice.h"

#include "cli/arguments.h"

namespace bodkin::cli {

// Probe, its place and the machine's knobs as the command line gives them.
struct UltrasoundOptions {
  std::string probe = "C5-2", probes;    // a name; a file of probes, empty: those that come with Bodkin
  std::string pose, face, look, marked;  // empty: found by a view
  std::string view, at, from;            // empty: the view's own
  std::string tgc, size = "640x480", mark = "left";
  double press = 3.0, depth = 0.0, gain = 0.0, dynamic_range = 60.0, focus = 0.0, frequency = 0.0;
  std::int64_t lines = 384, samples = 512, slices = 3, threads = 1;
  bool no_gel = false;
  bool needle = false;
  double needle_depth = 0.0;
  Argument press_given, depth_given, focus_given, frequency_given, size_given, needle_depth_given;
};

void add_ultrasound_options(CLI::App& command, UltrasoundOptions& options);

// Throws InputError naming the option.
station::UltrasoundChoice choose_ultrasound(const UltrasoundOptions& options);

// "a,b,..." as exactly `count` finite numbers; throws InputError naming `option`.
std::vector<double> parse_numbers(const std::string& text, std::size_t count, const std::string& option);

}  // namespace bodkin::cli
