#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "station/ultrasound_choice.h"

namespace bodkin::station {

// A probe, its place and the machine's settings as a person states them: the options of `bodkin ultrasound`, with the
// same names. Empty texts and absent numbers are derived from the view, the probe or the case.
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

// Interprets a request. Throws InputError naming the option.
UltrasoundChoice choose_ultrasound(const UltrasoundRequest& request);

// The requested needle in the patient; empty without `needle`. Throws InputError when the case has no path.
std::optional<imaging::NeedleInUltrasound> needle_of(const UltrasoundRequest& request, const anatomy::Case& patient);

// As JSON, for passing it to another program; throws InputError for an invalid `text`.
std::string to_json(const UltrasoundRequest& request);
UltrasoundRequest ultrasound_request(const std::string& text);

}  // namespace bodkin::station
