#pragma once

#include <optional>

#include <nlohmann/json_fwd.hpp>

#include "core/geometry.h"
#include "haptics/workspace_map.h"

namespace bodkin::station {

// The placement of a device relative to a mannequin that represents the patient, measured by 'bodkin devices touch'
// and 'bodkin register'.
struct MannequinPlace {
  Pose patient_from_hand = Pose::Identity();  // from the device's reported pose, mm, to LPS mm
  // The device holds a hub without its needle: the calibrated tip is the hub's, and the needle's tip lies its length
  // farther along its axis.
  bool at_hub = false;
};

// The registration includes the direction in which the device stands, and the middle of its workspace.
// `needle_length`: mm. `workspace`: as calibrated for a device whose patient lies below it.
void place_on(const MannequinPlace& place, double needle_length, haptics::WorkspaceSettings& workspace);

// In the format of a session; null for none.
nlohmann::ordered_json mannequin_json(const std::optional<MannequinPlace>& place);

}  // namespace bodkin::station
