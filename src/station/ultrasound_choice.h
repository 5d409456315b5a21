#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anatomy/case.h"
#include "imaging/ultrasound/ultrasound.h"
#include "imaging/ultrasound_screen/probe_on_skin.h"
#include "imaging/ultrasound_screen/scan_field.h"
#include "imaging/ultrasound_screen/scan_view.h"

namespace bodkin::station {

// The meaning of the options before a patient is known.
struct UltrasoundChoice {
  anatomy::UltrasoundProbe probe;
  imaging::UltrasoundSettings settings;
  imaging::UltrasoundDetail detail;
  imaging::OrientationMarkerSide mark = imaging::OrientationMarkerSide::left;
  std::optional<Pose> pose;      // as stated
  imaging::ScanRequest request;  // otherwise
  std::string at_name;           // of a landmark or a structure to look at; empty: request.at
  double press = 0.0;            // mm
};

// The probe as held on the patient. Throws InputError when there is no such place.
imaging::ProbeOnSkin hold_probe(const UltrasoundChoice& choice, const anatomy::Case& patient);

// The case's needle on its planned path, `depth` mm beyond the entry, by default at the target. Throws InputError
// when the case has no path.
imaging::NeedleInUltrasound needle_on_path(const anatomy::Case& patient, const std::optional<double>& depth);

// Twelve numbers row by row as a rigid pose, with or without the last row "0 0 0 1"; throws InputError naming
// `origin` for anything else.
Pose parse_pose(const std::vector<double>& numbers, const std::string& origin);
// The inverse of parse_pose().
std::string pose_text(const Pose& pose);

}  // namespace bodkin::station
