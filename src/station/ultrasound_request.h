#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "station/ultrasound_choice.h"

namespace bodkin::station {

// A probe, its place and the machine's knobs in the words of a person: what the options of `bodkin ultrasound` say,
// by the same names. Empty texts and absent numbers are found: by the view, the probe or the case.
struct UltrasoundRequest {
  std::string probe = "C5-2", probes;  // a name; a file of probes, empty: those that come with Bodkin
  std::string pose, face, look, marked;
  std::string view, at, from;
  std::string tgc, size = "640x480", mark = "left";
  double gain = 0.0, dynamic_range = 60.0;                  // dB
  std::optional<double> press, depth, focus, needle_depth;  // mm
  std::optional<double> frequency;                          // MHz
  std::int64_t lines = 384, samples = 512, slices = 3, threads = 1;
  bool no_gel = false;
  bool needle = false;
};

// What it means. Throws InputError naming the option.
UltrasoundChoice choose_ultrasound(const UltrasoundRequest& request);

// The needle that it wants in the patient; nothing without `needle`. Throws InputError when the case has no path.
std::optional<imaging::NeedleInSound> needle_of(const UltrasoundRequest& request, const anatomy::Case& patient);

// As JSON, by which one program gives it to another; throws InputError when `text` is none.
std::string to_json(const UltrasoundRequest& request);
UltrasoundRequest ultrasound_request(const std::string& text);

}  // namespace bodkin::station
