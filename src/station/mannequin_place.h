#pragma once

#include <optional>

#include <nlohmann/json_fwd.hpp>

#include "core/geometry.h"
#include "haptics/workspace_map.h"

namespace bodkin::station {

// How a device stands beside a mannequin that stands for the patient: 'bodkin devices touch' and 'bodkin register'
// measure it.
struct MannequinPlace {
  Pose patient_from_hand = Pose::Identity();  // from what the device reports, mm, to LPS mm
  // The device holds a hub without its needle: what was calibrated as the tip is the hub's, and the needle's tip lies
  // its length farther along its axis.
  bool at_hub = false;
};

// The registration has the way that the device stands in it, and where the middle of its workspace is.
// `needle_length`: mm. `workspace`: as calibrated for a device whose patient lies below it.
void place_on(const MannequinPlace& place, double needle_length, haptics::WorkspaceSettings& workspace);

// As a session records it; null for none.
nlohmann::ordered_json mannequin_json(const std::optional<MannequinPlace>& place);

}  // namespace bodkin::station
