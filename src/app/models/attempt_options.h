#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "station/station_options.h"

namespace bodkin::app {

// Options of `bodkin perform` for an attempt in the window, replacing those of the case and the window.
struct AttemptOptions {
  station::DeviceChoice device;        // no driver: the mouse
  std::string resistance, constraint;  // "NAME SETTING=VALUE ..."; empty: the case's
  std::vector<std::string> parts;      // all of them; empty: the case's
  std::optional<anatomy::Mechanics> mechanics;
  std::optional<anatomy::ForceInOrgans> force_in_organs;
  std::optional<station::UltrasoundChoice> ultrasound;
  std::optional<station::SecondChoice> second;
  std::optional<fem::ProbeFace> moving_body;
  std::vector<anatomy::NeedlePath> left_needles;  // left in the body earlier, from entry to tip
  std::optional<station::MannequinPlace> mannequin;
  double scale = 1.0, force_scale = 1.0;
  bool allow_late = false;
  bool use_calibration = true;
  std::filesystem::path output;  // empty: the window's own folder
  bool overwrite = false;
  double longest = 3600.0;  // s

  // All options except the ultrasound, which the window can switch off, and the output.
  void apply(station::StationOptions& station) const;
  // The file of attempt number `attempt` (from 0): the output, then NAME-2, NAME-3, ... skipping existing files.
  std::filesystem::path file_of(int attempt) const;
};

// From the JSON of `bodkin perform`. Throws InputError.
AttemptOptions read_attempt_options(const std::string& text);

}  // namespace bodkin::app
