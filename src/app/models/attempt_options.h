#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "station/station_options.h"

namespace bodkin::app {

// What `bodkin perform` asks of an attempt in the window, instead of what the case and the window would do.
struct AttemptOptions {
  station::DeviceChoice device;        // no driver: the mouse
  std::string resistance, constraint;  // "NAME SETTING=VALUE ..."; empty: the case's
  std::vector<std::string> parts;      // all of them; empty: the case's
  std::optional<anatomy::Mechanics> mechanics;
  std::optional<anatomy::ForceInOrgans> force_in_organs;
  std::optional<station::UltrasoundChoice> ultrasound;
  std::optional<station::SecondChoice> second;
  std::optional<fem::ProbeFace> moving_body;
  std::vector<anatomy::NeedlePath> left_needles;  // in the body before, from entry to tip
  std::optional<station::MannequinPlace> mannequin;
  double scale = 1.0, force_scale = 1.0;
  bool allow_late = false;
  bool use_calibration = true;
  std::filesystem::path output;  // empty: the window's own folder
  bool overwrite = false;
  double longest = 3600.0;  // s

  // Everything but the ultrasound, which the window can switch off, and the output.
  void apply(station::StationOptions& station) const;
  // Where attempt number `attempt` (from 0) is kept: the output, then NAME-2, NAME-3, ... that no file has yet.
  std::filesystem::path file_of(int attempt) const;
};

// From the JSON of `bodkin perform`. Throws InputError.
AttemptOptions read_attempt_options(const std::string& text);

}  // namespace bodkin::app
