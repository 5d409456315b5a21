#include "station/mannequin_place.h"

#include <utility>

#include <nlohmann/json.hpp>

namespace bodkin::station {

void place_on(const MannequinPlace& place, double needle_length, haptics::WorkspaceSettings& workspace) {
  workspace.rotation = place.patient_from_hand.linear();
  workspace.centre = place.patient_from_hand.translation();
  workspace.hand_middle = Vec3::Zero();
  if (place.at_hub) workspace.tip_offset += needle_length * workspace.tool_rotation.col(2);
}

nlohmann::ordered_json mannequin_json(const std::optional<MannequinPlace>& place) {
  if (!place) return {};
  constexpr int entries = 16;  // row by row
  nlohmann::ordered_json matrix = nlohmann::ordered_json::array();
  for (int i = 0; i < entries; ++i) matrix.push_back(place->patient_from_hand.matrix()(i / 4, i % 4));
  return {{"patient_from_hand", std::move(matrix)}, {"at_hub", place->at_hub}};
}

}  // namespace bodkin::station
