#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "anatomy/case.h"
#include "cli/arguments.h"
#include "imaging/ultrasound/ultrasound.h"
#include "imaging/ultrasound_screen/probe_on_skin.h"
#include "imaging/ultrasound_screen/scan_field.h"
#include "imaging/ultrasound_screen/scan_view.h"

namespace bodkin {

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

// What the options mean, as far as that can be told without a patient.
struct UltrasoundChoice {
  UltrasoundProbe probe;
  UltrasoundSettings settings;
  UltrasoundDetail detail;
  MarkSide mark = MarkSide::left;
  std::optional<Pose> pose;  // as given
  ScanRequest request;       // otherwise
  std::string at_name;       // of a landmark or a structure to look at; empty: request.at
  double press = 0.0;        // mm
};

// Throws InputError naming the option.
UltrasoundChoice choose_ultrasound(const UltrasoundOptions& options);

// The probe in the hand that holds it on the patient. Throws InputError when there is no such place.
ProbeOnSkin hold_probe(const UltrasoundChoice& choice, const Case& patient);

// The case's needle on its planned path, `depth` mm beyond the entry, the target's depth when there is none. Throws
// InputError when the case has no path.
NeedleInSound needle_on_path(const Case& patient, const std::optional<double>& depth);

// "a,b,..." as exactly `count` finite numbers; throws InputError naming `option`.
std::vector<double> parse_numbers(const std::string& text, std::size_t count, const std::string& option);
// Twelve numbers row by row as a rigid pose, with or without the last row "0 0 0 1"; throws InputError naming
// `origin` when they are none.
Pose parse_pose(const std::vector<double>& numbers, const std::string& origin);
// The other way round.
std::string pose_text(const Pose& pose);

}  // namespace bodkin
