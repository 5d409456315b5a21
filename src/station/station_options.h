#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "station/mannequin_place.h"
#include "station/second_device.h"
#include "station/ultrasound_choice.h"

#include "anatomy/case.h"
#include "fem/moving/probe_press.h"

namespace bodkin::station {

// Everything from which a running session is assembled. Force models, tissues and limits are those of `patient`;
// change them there to use others.
struct StationOptions {
  anatomy::Case patient;
  std::filesystem::path case_folder;        // its source: its case.xml is recorded, its mesh is read
  std::optional<anatomy::NeedlePath> path;  // path of the procedure; empty: the case's planned path
  DeviceChoice device;                      // holds the needle
  double scale = 1.0;                       // mm of the needle per mm of the hand, 0.1 to 10
  double force_scale = 1.0;                 // N at the hand per N of the needle, 0.01 to 1
  // The patient is placed at a mannequin, and stays there; empty: below the middle of the workspace.
  std::optional<MannequinPlace> mannequin;
  // Without real-time priority and locked memory the force is capped, unless the user accepts the risk.
  bool allow_late = false;
  bool use_calibration = true;  // the measurements of 'bodkin devices calibrate' for the devices
  std::optional<SecondChoice> second;
  // Empty: a body is rigid or static, depending on the resistance. Otherwise it moves, pressed by the probe of the
  // second device, which has this face.
  std::optional<fem::ProbeFace> moving_body;
  // Needles left in the body earlier, from their entry to their tip at rest. The resistance with contact points
  // couples them with the needle in the hand.
  std::vector<anatomy::NeedlePath> left_needles;
  std::optional<UltrasoundChoice> ultrasound;
  std::filesystem::path output = "session-by-hand.bodkin";
  bool overwrite = false;
  double longest = 600.0;  // s on the clock after which the session ends, more than 0
};

}  // namespace bodkin::station
